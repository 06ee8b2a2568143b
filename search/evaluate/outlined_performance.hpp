// Uniformity and motor efficiency over the grasps, as bounds give them.
#pragma once

#include <algorithm>
#include <limits>

#include "numerics/floors.hpp"

namespace reeve::search {

struct OutlinedValue {
  double uniformity = 0;
  double efficiency = 0;
};

struct OutlinedPerformance {
  OutlinedValue mean;
  OutlinedValue worst{std::numeric_limits<double>::infinity(),
                      std::numeric_limits<double>::infinity()};

  // `share` is that of the grasp's weight.
  void add(double share, const OutlinedValue& value) {
    mean.uniformity += share * value.uniformity;
    mean.efficiency += share * value.efficiency;
    worst.uniformity = std::min(worst.uniformity, value.uniformity);
    worst.efficiency = std::min(worst.efficiency, value.efficiency);
  }
};

}  // namespace reeve::search
