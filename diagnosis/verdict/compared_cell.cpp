#include "diagnosis/verdict/compared_cell.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "diagnosis/fit/forecast.hpp"
#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {
namespace {

// Forecasts by reading and channel.
using LeftOutForecasts = std::map<std::pair<std::size_t, std::size_t>, double>;

LeftOutForecasts forecasts_of(const std::vector<LeftOutRun>& runs) {
  LeftOutForecasts forecasts;
  for (const LeftOutRun& run : runs) {
    for (std::size_t i = 0; i < run.cells.size(); ++i) {
      forecasts[{run.cells[i].reading, run.cells[i].channel}] = run.forecast_N[i];
    }
  }
  return forecasts;
}

}  // namespace

std::vector<ComparedCell> compared_cells(const Sample& sample, const Model& before,
                                         const Model& after, const Scatter& scatter,
                                         const std::vector<LeftOutRun>& left_out,
                                         Workers& workers) {
  const LeftOutForecasts others = forecasts_of(left_out);
  std::vector<ComparedCell> result;
  for (const bool held_out : {false, true}) {
    const Dataset& part = held_out ? sample.held_out : sample.training;
    if (part.cells.empty()) continue;
    const Forecast at_first = forecast(part, before);
    const Forecast at_last = forecast(part, after);
    const Problem seen = problem(part, scatter, after, workers);
    const Eigen::VectorXd deviation = total_deviations(seen);
    const Eigen::VectorXd share = seen.deviation_N.cwiseQuotient(deviation);
    const Eigen::VectorXd residual_before = own_residuals(seen, at_first).cwiseProduct(share);
    const Eigen::VectorXd residual_after = own_residuals(seen, at_last).cwiseProduct(share);
    for (std::size_t i = 0; i < part.cells.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      const auto other = others.find({part.cells[i].reading, part.cells[i].channel});
      result.push_back({part.cells[i], held_out, at_first.reading_N[k], at_last.reading_N[k],
                        deviation[k], residual_before[k], residual_after[k],
                        other == others.end() ? std::nullopt : std::optional(other->second)});
    }
  }
  const std::vector<Reading>& readings = sample.training.data->readings;
  std::ranges::stable_sort(result, [&](const ComparedCell& a, const ComparedCell& b) {
    return readings[a.cell.reading].line < readings[b.cell.reading].line;
  });
  return result;
}

}  // namespace reeve::diagnosis
