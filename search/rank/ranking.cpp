#include "search/rank/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>
#include <utility>

#include "search/rank/pareto.hpp"

namespace reeve::search {

double part_total(const ObjectiveValues& values) {
  return value(values, Objective::sheaths) + value(values, Objective::pulleys) +
         value(values, Objective::knots) + value(values, Objective::blocks);
}

double uniformity_times_efficiency(const ObjectiveValues& values) {
  return value(values, Objective::uniformity_mean) * value(values, Objective::efficiency_mean);
}

double decisive_value(const ObjectiveValues& values, const Order& order) {
  return order.by_score ? value(values, Objective::score) : uniformity_times_efficiency(values);
}

std::vector<Objective> within_front_objectives(const Order& order) {
  const std::vector<Objective> by_score{Objective::score, Objective::sheaths, Objective::pulleys,
                                        Objective::knots, Objective::blocks};
  const std::vector<Objective> by_product{Objective::uniformity_mean, Objective::efficiency_mean,
                                          Objective::sheaths,         Objective::pulleys,
                                          Objective::knots,           Objective::blocks};
  return order.by_score ? by_score : by_product;
}

namespace {

using WithinFrontKey = std::tuple<double, double, std::string_view>;

WithinFrontKey within_front_key(const Design& design, const Order& order) {
  return {-decisive_value(design.values, order), part_total(design.values), design.word};
}

}  // namespace

bool precedes_within_front(const Design& a, const Design& b, const Order& order) {
  return within_front_key(a, order) < within_front_key(b, order);
}

std::vector<RankedDesign> rank(std::vector<Design> designs, const Order& order) {
  const std::vector<Objective>& objectives = order.objectives;
  GoodnessMatrix matrix(static_cast<Eigen::Index>(designs.size()),
                        static_cast<Eigen::Index>(objectives.size()));
  for (std::size_t i = 0; i < designs.size(); ++i) {
    matrix.row(static_cast<Eigen::Index>(i)) = goodness(designs[i].values, objectives).transpose();
  }
  const std::vector<int> front = fronts(matrix);
  // Designs are large, and compared many times. The keys hold views of their words, which are
  // moved when the keys have served.
  std::vector<std::tuple<int, WithinFrontKey, std::size_t>> places;
  places.reserve(designs.size());
  for (std::size_t i = 0; i < designs.size(); ++i) {
    places.emplace_back(front[i], within_front_key(designs[i], order), i);
  }
  std::sort(places.begin(), places.end());
  std::vector<RankedDesign> ranked;
  ranked.reserve(designs.size());
  for (const auto& [of_front, key, given] : places) {
    ranked.push_back({std::move(designs[given]), of_front, ranked.size() + 1, given});
  }
  return ranked;
}

namespace {

void hold_against(const Design& design, std::size_t named, BestDesigns& best) {
  const double candidate = value(design.values, best.objective);
  const bool better = row(best.objective).better == Better::higher ? candidate > best.value
                                                                   : candidate < best.value;
  if (best.count == 0 || better) best = {best.objective, candidate, {}, 0};
  if (candidate != best.value) return;
  if (best.words.size() < named) best.words.push_back(design.word);
  ++best.count;
}

}  // namespace

std::vector<BestDesigns> best_by_objective(const std::vector<RankedDesign>& ranked,
                                           std::size_t named) {
  std::vector<BestDesigns> result;
  if (ranked.empty()) return result;
  for (const ObjectiveRow& row : objective_table()) {
    if (is_there(row, ranked.front().design.values)) result.push_back({row.objective, 0, {}, 0});
  }
  for (const RankedDesign& entry : ranked) {
    for (BestDesigns& best : result) hold_against(entry.design, named, best);
  }
  // Without prices there is no cost to be best by.
  std::erase_if(result, [](const BestDesigns& best) {
    return best.objective == Objective::cost && !std::isfinite(best.value);
  });
  return result;
}

}  // namespace reeve::search
