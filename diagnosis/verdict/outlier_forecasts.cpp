#include "diagnosis/verdict/outlier_forecasts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "diagnosis/verdict/structure.hpp"
#include "numerics/student_t.hpp"

namespace reeve::diagnosis {
namespace {

constexpr std::size_t most_told = 3;
constexpr double most_degrees = 6;

double far(const Noise& noise, double alpha, std::size_t cells) {
  const double chance = structure_share_of_alpha * alpha / static_cast<double>(cells);
  return student_t_quantile(1 - chance / 2,
                            std::clamp(noise.degrees_of_freedom, 1.0, most_degrees));
}

std::string told(const ComparedCell& cell, const MeasuredData& data) {
  return fmt::format("line {}: {} reads {:.3g} N, forecast {:.3g} N",
                     data.readings[cell.cell.reading].line, data.channels[cell.cell.channel].name,
                     cell.cell.measured_N, cell.after_N);
}

}  // namespace

std::optional<DataNote> outlier_forecasts(const std::vector<ComparedCell>& cells,
                                          const MeasuredData& data, const Noise& noise,
                                          double alpha) {
  const auto held_out =
      static_cast<std::size_t>(std::ranges::count_if(cells, &ComparedCell::held_out));
  if (held_out == 0) return std::nullopt;
  const double limit = far(noise, alpha, held_out);
  std::vector<const ComparedCell*> beyond;
  for (const ComparedCell& cell : cells) {
    if (cell.held_out && std::abs(cell.residual_after) > limit) beyond.push_back(&cell);
  }
  if (beyond.empty()) return std::nullopt;
  DataNote note{NoteKind::outlier_forecast, "", {}};
  for (const ComparedCell* cell : beyond) {
    note.lines.push_back(data.readings[cell->cell.reading].line);
  }
  note.lines.erase(std::unique(note.lines.begin(), note.lines.end()), note.lines.end());
  std::ranges::stable_sort(beyond, [](const ComparedCell* a, const ComparedCell* b) {
    return std::abs(a->residual_after) > std::abs(b->residual_after);
  });
  std::string examples;
  for (std::size_t i = 0; i < std::min(beyond.size(), most_told); ++i) {
    examples += (i == 0 ? "" : "; ") + told(*beyond[i], data);
  }
  note.text = fmt::format(
      "{} reading{} of held-out runs {} more than {:.2g} standard deviations off what the model "
      "forecasts, which chance does nowhere in more than {:.2g} % of data sets ({}{}): something is "
      "different there that no training run knows",
      beyond.size(), beyond.size() == 1 ? "" : "s", beyond.size() == 1 ? "is" : "are", limit,
      100 * structure_share_of_alpha * alpha, examples, beyond.size() > most_told ? "; …" : "");
  return note;
}

}  // namespace reeve::diagnosis
