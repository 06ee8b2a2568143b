#include "studies/comparison_study.hpp"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "causes/term.hpp"
#include "diagnosis/dataset.hpp"

namespace reeve::studies {
namespace {

// A law is held constant outside the range in which it was seen.
void note_outside_laws(const Model& model, const MeasuredData& data, std::vector<DataNote>& notes) {
  std::vector<std::size_t> readings(data.readings.size());
  std::iota(readings.begin(), readings.end(), std::size_t{0});
  const Dataset dataset = diagnosis::dataset(data, readings, Rows::all);
  for (const Effect& effect : model.effects) {
    for (const Covariate& x : covariates(effect)) {
      if (is_of_tensions(x)) continue;
      DataNote note{NoteKind::outside_law, "", {}};
      for (const DatasetRow& row : dataset.rows) {
        const double value = covariate_value(x, row.conditions, 0);
        const bool is_outside = value < x.seen.low || value > x.seen.high;
        if (is_outside) note.lines.push_back(data.readings[row.reading].line);
      }
      if (note.lines.empty()) continue;
      note.text = fmt::format(
          "{} lies outside {:.6g} to {:.6g}, where {} was seen, in {} of {} "
          "readings: the law is held constant there",
          covariate_name(x), x.seen.low, x.seen.high, effect_name(effect), note.lines.size(),
          dataset.rows.size());
      notes.push_back(std::move(note));
    }
  }
}

}  // namespace

CompareReport comparison_study(MeasuredData data, const Model& model, const Catalogue& catalogue) {
  CompareReport report;
  report.data = std::move(data);
  report.model = model;
  for (const MeasuredRouting& measured : report.data.routings) {
    report.names.push_back(name_of(catalogue, measured.routing));
  }
  report.comparison = compare(report.data, model);
  note_outside_laws(model, report.data, report.comparison.notes);
  return report;
}

}  // namespace reeve::studies
