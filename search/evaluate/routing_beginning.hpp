// The beginning of routings: some of their trees, or all.
//
// It bounds every routing that begins so. In a grasp, of the states of these trees with least and
// greatest strand tension, motor tension m and work w in all (tree_spans.hpp),
//
//   uniformity <= least / most,  efficiency <= (w + E M) / (m + M)
//
// where E = e^{-phi} of a sheath, which no efficiency exceeds (core/performance.hpp), and M is the
// greatest motor tension that trees on the open fingers have in any state. With no open finger both
// are equal but for rounding.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "search/evaluate/tree_spans.hpp"

namespace reeve::search {

struct RoutingBeginning {
  std::vector<const TreeOutline*> trees;  // in the order of the routing
  int open = 0;                           // number of fingers on other trees, behind these
  double most_motor_tension = 0;          // M
  // True if it is not known how bad a routing that begins so can be, even if no finger is open.
  bool bounds_best_alone = false;
};

// Uniformity and motor efficiency over the grasps, as bounds give them.
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
