#include "search/judge/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "search/judge/pareto.hpp"

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

bool precedes_within_front(const Design& a, const Design& b, const Order& order) {
  const auto key = [&](const Design& design) {
    return std::make_tuple(-decisive_value(design.values, order), part_total(design.values),
                           std::string_view(design.word));
  };
  return key(a) < key(b);
}

std::vector<RankedDesign> rank(std::vector<Design> designs, const Order& order) {
  const std::vector<Objective>& objectives = order.objectives;
  GoodnessMatrix matrix(static_cast<Eigen::Index>(designs.size()),
                        static_cast<Eigen::Index>(objectives.size()));
  for (std::size_t i = 0; i < designs.size(); ++i) {
    matrix.row(static_cast<Eigen::Index>(i)) = goodness(designs[i].values, objectives).transpose();
  }
  const std::vector<int> front = fronts(matrix);
  std::vector<RankedDesign> ranked;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    ranked.push_back({std::move(designs[i]), front[i], 0, i});
  }
  std::sort(ranked.begin(), ranked.end(), [&](const RankedDesign& a, const RankedDesign& b) {
    if (a.front != b.front) return a.front < b.front;
    return precedes_within_front(a.design, b.design, order);
  });
  for (std::size_t i = 0; i < ranked.size(); ++i) ranked[i].rank = i + 1;
  return ranked;
}

std::vector<BestDesigns> best_by_objective(const std::vector<RankedDesign>& ranked,
                                           std::size_t named) {
  std::vector<BestDesigns> result;
  if (ranked.empty()) return result;
  for (const ObjectiveRow& row : objective_table()) {
    if (!is_there(row, ranked.front().design.values)) continue;
    BestDesigns best{row.objective, 0, {}, 0};
    for (const RankedDesign& entry : ranked) {
      const double candidate = value(entry.design.values, row.objective);
      const bool better =
          row.better == Better::higher ? candidate > best.value : candidate < best.value;
      if (best.count == 0 || better) best = {row.objective, candidate, {}, 0};
      if (candidate != best.value) continue;
      if (best.words.size() < named) best.words.push_back(entry.design.word);
      ++best.count;
    }
    // Without prices there is no cost to be best by.
    const bool unknown = row.objective == Objective::cost && !std::isfinite(best.value);
    if (!unknown) result.push_back(std::move(best));
  }
  return result;
}

}  // namespace reeve::search
