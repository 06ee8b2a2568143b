#include "search/uncertainty/bands.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/robust.hpp"

namespace reeve::search {
namespace {

constexpr double tail = 0.05;

// Between two infinite values a quantile is no number, and stands for what both are.
double quantile_or_infinite(const std::vector<double>& values, double share) {
  const double quantile = quantile_of(values, share);
  return std::isnan(quantile) ? std::numeric_limits<double>::infinity() : on_grid(quantile);
}

}  // namespace

const Band* find_band(const Bands& bands, Objective objective) {
  const auto found = std::find_if(bands.begin(), bands.end(), [&](const ObjectiveBand& entry) {
    return entry.objective == objective;
  });
  return found == bands.end() ? nullptr : &found->band;
}

bool depends_on_friction(Objective objective) {
  switch (objective) {
    case Objective::travel:
    case Objective::cost:
    case Objective::stroke:
    case Objective::closure:
    case Objective::uniformity_p5:  // quantiles over draws already
    case Objective::efficiency_p5:
      return false;
    default:
      return !row(objective).is_count();
  }
}

std::vector<Objective> friction_objectives(bool with_hand) {
  std::vector<Objective> objectives;
  for (const ObjectiveRow& about : objective_table()) {
    const bool is_there = with_hand || !about.of_hand;
    if (is_there && depends_on_friction(about.objective)) objectives.push_back(about.objective);
  }
  return objectives;
}

Band band_of(const std::vector<double>& values) {
  return {quantile_or_infinite(values, 0.5), quantile_or_infinite(values, tail),
          quantile_or_infinite(values, 1 - tail)};
}

}  // namespace reeve::search
