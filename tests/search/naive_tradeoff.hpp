// The trade-off by its definition, with every design in memory: for each amount of the measure all
// designs with at most as much, compared pair by pair.
#pragma once

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "search/rank/tradeoff.hpp"

namespace reeve::testing {

inline double worth(const Design& design, Objective objective) {
  const double v = value(design.values, objective);
  return row(objective).better == Better::higher ? v : -v;
}

inline bool nowhere_worse(const Design& a, const Design& b,
                          const std::vector<Objective>& objectives) {
  return std::all_of(objectives.begin(), objectives.end(),
                     [&](Objective o) { return worth(a, o) >= worth(b, o); });
}

inline bool equal_in(const Design& a, const Design& b, const std::vector<Objective>& objectives) {
  return nowhere_worse(a, b, objectives) && nowhere_worse(b, a, objectives);
}

// The first of these: none dominates it, and no equal one has less of the measure.
inline const Design& naive_first(const std::vector<Design>& designs, const Order& order,
                                 Objective by) {
  const Design* best = nullptr;
  for (const Design& design : designs) {
    const bool beaten = std::any_of(designs.begin(), designs.end(), [&](const Design& other) {
      if (!nowhere_worse(other, design, order.objectives)) return false;
      if (!nowhere_worse(design, other, order.objectives)) return true;
      const bool scored = order.by_score && value(other.values, Objective::score) !=
                                                value(design.values, Objective::score);
      return !scored && value(other.values, by) < value(design.values, by);
    });
    if (beaten) continue;
    if (best == nullptr || precedes_within_front(design, *best, order)) best = &design;
  }
  return *best;
}

inline std::vector<std::pair<double, std::string>> naive_tradeoff(
    const std::vector<Design>& designs, const Order& order, Objective by) {
  std::set<double> amounts;
  for (const Design& design : designs) amounts.insert(value(design.values, by));
  std::vector<std::pair<double, std::string>> steps;
  for (const double amount : amounts) {
    std::vector<Design> within;
    std::copy_if(designs.begin(), designs.end(), std::back_inserter(within),
                 [&](const Design& design) { return value(design.values, by) <= amount; });
    const Design& first = naive_first(within, order, by);
    if (steps.empty() || steps.back().second != first.word) {
      steps.emplace_back(amount, first.word);
    }
  }
  return steps;
}

// The least of the measure among all that lose at most `within` in every ranked objective.
inline double naive_least(const std::vector<Design>& designs, const Design& first,
                          const std::vector<Objective>& objectives, Objective by, double within) {
  double least = value(first.values, by);
  for (const Design& design : designs) {
    const bool bearable = std::all_of(objectives.begin(), objectives.end(), [&](Objective o) {
      return worth(design, o) >= worth(first, o) - within * std::abs(worth(first, o)) - 1e-9;
    });
    if (bearable) least = std::min(least, value(design.values, by));
  }
  return least;
}

}  // namespace reeve::testing
