#include "diagnosis/verdict/folds.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "causes/term.hpp"
#include "diagnosis/search/defence.hpp"

namespace reeve::diagnosis {

using Eigen::Index;

std::vector<std::size_t> readings_in(const Dataset& part) {
  std::vector<std::size_t> readings;
  for (const DatasetRow& row : part.rows) readings.push_back(row.reading);
  return readings;
}

std::vector<std::size_t> dealt_runs(const MeasuredData& data,
                                    const std::vector<std::size_t>& readings, std::size_t folds) {
  std::vector<std::size_t> fold(data.runs.size(), folds);
  std::map<std::size_t, std::size_t> dealt;  // number dealt, by routing
  for (const std::size_t i : readings) {
    const Reading& reading = data.readings[i];
    if (fold[reading.run] != folds) continue;
    fold[reading.run] = (reading.routing + dealt[reading.routing]++) % folds;
  }
  return fold;
}

std::vector<Fold> cross_validated(const MeasuredData& data,
                                  const std::vector<std::size_t>& readings, const Model& nominal,
                                  const TermSearch& search, Workers& workers) {
  std::vector<Fold> result;
  std::vector<std::size_t> runs;
  for (const std::size_t i : readings) runs.push_back(data.readings[i].run);
  std::ranges::sort(runs);
  runs.erase(std::unique(runs.begin(), runs.end()), runs.end());
  if (runs.size() < 2) return result;
  const std::size_t folds = std::min(most_folds, runs.size());
  const std::vector<std::size_t> fold_of = dealt_runs(data, readings, folds);
  std::vector<std::optional<Fold>> searched(folds);
  workers.for_each_block(folds, 1, [&](const IndexBlock& block) {
    std::vector<std::size_t> seen, unseen;
    for (const std::size_t i : readings) {
      (fold_of[data.readings[i].run] == block.begin ? unseen : seen).push_back(i);
    }
    Fold fold{dataset(data, unseen), dataset(data, seen), {}, {}, {}, {}};
    if (fold.unseen.cells.empty() || fold.seen.cells.empty()) return;
    Workers alone(1);
    fold.found = search.run_on(fold.seen, alone);
    fold.nominal = forecast(fold.unseen, nominal);
    fold.base = try_forecast(fold.unseen, fold.found.base).value_or(fold.nominal);
    fold.forecast = try_forecast(fold.unseen, fold.found.model).value_or(fold.base);
    // It refers to a dataset that is about to move.
    fold.found.problem.dataset = nullptr;
    searched[block.begin] = std::move(fold);
  });
  for (std::optional<Fold>& fold : searched) {
    if (fold) result.push_back(std::move(*fold));
  }
  return result;
}

namespace {

// A fold does not see all of the runs that something is about.
bool is_of_some_of_its_runs(const Effect& found, const Effect& cause) {
  if (!acts_alike(found, cause)) return false;
  const auto& runs = term_of(*found.cause)->site.runs;
  const auto& all = term_of(*cause.cause)->site.runs;
  return !runs.empty() && std::ranges::all_of(runs, [&](const std::string& run) {
    return std::ranges::find(all, run) != all.end();
  });
}

}  // namespace

bool stands_for(const Effect& found, const AcceptedTerm& cause) {
  const std::string name = effect_name(found);
  return name == effect_name(cause.effect) || is_kin(found, cause.effect) ||
         differ_in_group(found, cause.effect) || is_of_some_of_its_runs(found, cause.effect) ||
         std::ranges::any_of(cause.alternatives,
                             [&](const Alternative& other) { return other.name() == name; });
}

double share_of_folds(const std::vector<Fold>& folds, const AcceptedTerm& cause,
                      std::size_t place) {
  if (folds.empty()) return 1;
  const auto is_it = [&](const AcceptedTerm& found) { return stands_for(found.effect, cause); };
  const auto finds = [&](const Fold& fold) {
    return fold.found.holds[place] || std::ranges::any_of(fold.found.accepted, is_it);
  };
  return static_cast<double>(std::ranges::count_if(folds, finds)) /
         static_cast<double>(folds.size());
}

Forecast joined(const std::vector<Fold>& folds, const Dataset& all,
                const std::function<Forecast(const Fold&)>& of) {
  Forecast result{Eigen::VectorXd::Zero(static_cast<Index>(all.cells.size())),
                  Eigen::VectorXd::Zero(static_cast<Index>(all.cells.size())),
                  std::vector<bool>(all.rows.size(), false)};
  for (const Fold& fold : folds) {
    const Forecast own = of(fold);
    const std::vector<Index> cells = cells_of_part(all, fold.unseen);
    result.reading_N(cells) = own.reading_N;
    result.by_scale(cells) = own.by_scale;
    const std::vector<Index> rows = rows_of_part(all, fold.unseen);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      result.jams[static_cast<std::size_t>(rows[r])] = own.jams[r];
    }
  }
  return result;
}

}  // namespace reeve::diagnosis
