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

#include <vector>

#include "search/evaluate/tree_spans.hpp"

namespace reeve::search {

struct RoutingBeginning {
  std::vector<const TreeOutline*> trees;  // in the order of the routing
  int open = 0;                           // number of fingers on other trees, behind these
  double most_motor_tension = 0;          // M
};

}  // namespace reeve::search
