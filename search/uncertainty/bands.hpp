// Bands of a design's objectives under drawn coefficients: median, 5 % and 95 % quantile.
//
// The value of a draw is the objective over all grasps of the ranking, at that draw's coefficients.
// Quantiles are those of `size` (numerics/robust.hpp), with linear interpolation between two draws.
#pragma once

#include <vector>

#include "search/evaluate/objectives.hpp"

namespace reeve::search {

struct Band {
  double median = 0;
  double low = 0;   // 5 % quantile
  double high = 0;  // 95 % quantile

  bool is_point() const { return low == high; }
};

struct ObjectiveBand {
  Objective objective{};
  Band band;
};

// Bands of one design, in the order of the table of objectives. Empty without draws.
using Bands = std::vector<ObjectiveBand>;

const Band* find_band(const Bands& bands, Objective objective);

// True if friction changes the objective, so that draws make a band of it. Numbers of parts and
// finger and carriage positions do not depend on friction. Quantiles over contacts already come
// from draws.
bool depends_on_friction(Objective objective);

// Returns the objectives that depend on friction, of hardware with or without a hand.
std::vector<Objective> friction_objectives(bool with_hand);

// Infinite values are the worst or the best, as they are; none is NaN.
Band band_of(const std::vector<double>& values);

}  // namespace reeve::search
