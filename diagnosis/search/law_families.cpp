#include "diagnosis/search/law_families.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr std::size_t few_groups = 2;

// Cells of each run or each group, by its name.
using Parts = std::map<std::size_t, std::vector<Index>>;

void screen(const LawColumns& columns, const Parts& parts, const std::vector<std::string>& names,
            std::string Site::*restricted, FoundLaws& found) {
  MatrixXd values = MatrixXd::Zero(static_cast<Index>(columns.dataset().cells.size()),
                                   static_cast<Index>(parts.size()));
  Index own = 0;
  for (const auto& [part, cells] : parts) values.col(own++)(cells).setOnes();
  for (std::size_t l = 0; l < columns.table().levers.size(); ++l) {
    if (!columns.is_whole(l)) continue;
    const MatrixXd seen = columns.columns(columns.lever(l), values);
    own = 0;
    for (const auto& [part, cells] : parts) {
      const LawFamily of = columns.family(seen, {own++});
      if (!(of.gain > 0)) continue;
      LeverLaw law = found.law_of_part(l, parts.size(), restricted == &Site::run);
      law.term.site.*restricted = names[part];
      found.keep(law, of.gain, {of.size[0]});
    }
  }
}

}  // namespace

void screen_parts(const LawColumns& columns, FoundLaws& found) {
  Parts runs, groups;
  const MeasuredData& data = *columns.dataset().data;
  for (std::size_t i = 0; i < columns.dataset().cells.size(); ++i) {
    const Reading& reading = data.readings[columns.dataset().cells[i].reading];
    runs[reading.run].push_back(static_cast<Index>(i));
    if (reading.group) groups[*reading.group].push_back(static_cast<Index>(i));
  }
  if (runs.size() >= few_runs) screen(columns, runs, data.runs, &Site::run, found);
  if (groups.size() >= few_groups) screen(columns, groups, data.groups, &Site::group, found);
}

namespace {

// A law of a motor tension that scatters, or that is the same in all rows, would follow nothing.
bool motor_is_covariate(const LawColumns& columns) {
  return std::ranges::any_of(columns.table().covariates, [&](const RowCovariate& of) {
    return of.is_motor && !columns.is_of_noise(of);
  });
}

// The tensions of each cell's row: those of the channels, and the motor's.
struct RowTensions {
  std::vector<Covariate> covariates;
  MatrixXd tension_N;  // 0 where the row does not have it
};

RowTensions row_tensions(const LawColumns& columns) {
  const Dataset& dataset = columns.dataset();
  const std::vector<Channel>& channels = dataset.data->channels;
  const auto motor = static_cast<Index>(channels.size());
  RowTensions result;
  result.tension_N = MatrixXd::Zero(static_cast<Index>(dataset.cells.size()), motor + 1);
  for (const DatasetRow& row : dataset.rows) {
    const auto first = static_cast<Index>(row.first);
    const auto size = static_cast<Index>(row.last - row.first);
    for (Index i = first; i < first + size; ++i) {
      const auto channel = static_cast<Index>(dataset.cells[static_cast<std::size_t>(i)].channel);
      result.tension_N.col(channel)
          .segment(first, size)
          .setConstant(columns.forecast().reading_N[i]);
    }
    if (row.has_motor_tension && motor_is_covariate(columns)) {
      result.tension_N.col(motor).segment(first, size).setConstant(row.conditions.motor_tension_N);
    }
  }
  for (Index c = 0; c <= motor; ++c) {
    Covariate& of = result.covariates.emplace_back();
    of.kind = c == motor ? causes::CovariateKind::motor : causes::CovariateKind::tension;
    if (c != motor) of.segment = channels[static_cast<std::size_t>(c)].segment;
    of.seen = {0, result.tension_N.col(c).maxCoeff()};
  }
  return result;
}

}  // namespace

void screen_tensions(const LawColumns& columns, FoundLaws& found) {
  const RowTensions tensions = row_tensions(columns);
  for (std::size_t l = 0; l < columns.table().levers.size(); ++l) {
    const Lever& lever = columns.lever(l);
    if (lever.target != Target::offset || lever.site.place == SitePlace::motor) continue;
    const MatrixXd seen = columns.columns(lever, tensions.tension_N);
    for (std::size_t c = 0; c < tensions.covariates.size(); ++c) {
      const Covariate& tension = tensions.covariates[c];
      const bool is_own = lever.site.place == SitePlace::channels
                              ? tension.kind == causes::CovariateKind::tension
                              : tension.segment == lever.site.channel;
      if (is_own) continue;
      const LawFamily of = columns.family(seen, {static_cast<Index>(c)});
      if (!(of.gain > 0)) continue;
      found.keep(found.law_of_tension(l, tension, c, tensions.covariates.size()), of.gain,
                 {of.size[0]});
    }
  }
}

std::vector<ScreenedLaw> best_laws(const LawTable& table, const Problem& problem,
                                   const Forecast& at, const Projection& projection,
                                   const Eigen::VectorXd& residuals, std::size_t most) {
  if (most == 0) return {};
  const LawColumns columns(table, problem, at, projection, residuals);
  FoundLaws found(columns);
  const std::vector<Bend> bends = screen_straight(columns, found);
  screen_waves(columns, found);
  screen_parts(columns, found);
  screen_tensions(columns, found);
  screen_bent(columns, bends, found);
  return found.best(most);
}

}  // namespace reeve::diagnosis
