#include "diagnosis/verdict/left_out.hpp"

#include <set>
#include <utility>

#include "diagnosis/fit/fit.hpp"

namespace reeve::diagnosis {
namespace {

// Parameters that these readings say nothing about go back to their nominal values.
Model fitted(const Problem& problem, Model model) {
  constexpr double clearly = 1e-6;
  const double here = misfit(problem, model);
  for (Effect& effect : model.effects) {
    const auto parameters = effect.cause->parameters(model.hardware);
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      if (!parameters[p].nominal) continue;
      const double value = std::exchange(effect.values[p], *parameters[p].nominal);
      if (here < (1 - clearly) * misfit(problem, model)) effect.values[p] = value;
    }
  }
  return fit(problem, model).model;
}

LeftOutRun left_out(const Problem& all, std::size_t run, const Model& model) {
  const MeasuredData& data = *all.dataset->data;
  std::vector<std::size_t> own, others;
  for (const DatasetRow& row : all.dataset->rows) {
    (data.readings[row.reading].run == run ? own : others).push_back(row.reading);
  }
  const Dataset rest = dataset(data, others);
  const Problem known = part_of(all, rest);
  LeftOutRun result{run, fitted(known, model), {}, {}};
  const Dataset unseen = dataset(data, own);
  // Fitted to the others, the model may have no tensions here.
  if (const auto at = try_forecast(unseen, result.model)) {
    result.cells = unseen.cells;
    result.forecast_N.assign(at->reading_N.begin(), at->reading_N.end());
  }
  return result;
}

}  // namespace

std::vector<LeftOutRun> left_out_runs(const MeasuredData& data,
                                      const std::vector<std::size_t>& readings, const Model& model,
                                      const Scatter& scatter, Workers& workers) {
  std::set<std::size_t> seen;
  for (const std::size_t i : readings) seen.insert(data.readings[i].run);
  if (parameter_count(model) == 0 || seen.size() < fewest_runs_left_out ||
      seen.size() > most_runs_left_out) {
    return {};
  }
  const std::vector<std::size_t> runs(seen.begin(), seen.end());
  const Dataset together = dataset(data, readings);
  const Problem all = problem(together, scatter, model, workers);
  std::vector<LeftOutRun> result(runs.size());
  workers.for_each_block(runs.size(), 1, [&](const IndexBlock& block) {
    result[block.begin] = left_out(all, runs[block.begin], model);
  });
  return result;
}

}  // namespace reeve::diagnosis
