// What a few sums say of a tree of tendons: enough to know that a routing is far from what is kept.
#pragma once

#include <vector>

#include "core/performance.hpp"

namespace reeve::search {

// What a state adds to a routing (solved_trees.hpp has the t_i).
struct TreeSums {
  bool jams = false;
  bool in_range = true;
  double motor = 0;     // Σ t_j of the motor-side segments
  StrandTally strands;  // of the t_i

  bool has_strands() const { return strands.least <= strands.most; }
  TreeSums& operator+=(const TreeSums& other);
};

struct TreeOutline {
  PartCount parts;
  std::vector<TreeSums> sums;  // with no finger held, and with each
};

}  // namespace reeve::search
