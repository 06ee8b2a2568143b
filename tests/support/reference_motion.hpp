// How a tree moves when its fingers close: the kinematics at order one, D = 1.
#pragma once

#include <map>
#include <vector>

#include "tests/support/reference_tree.hpp"

namespace reeve::testing::reference {

struct Motion {
  bool possible = false;        // otherwise the tree jams
  std::map<int, Real> closing;  // dl_f
  Vector z;                     // of each block, toward its tails
  std::vector<bool> slack{};    // of each span; empty if none is
};

// For every tendon  sum_i c_i (motor_i + C_i z - dl_f(i)) = 0,  with dl_f = w_f q_f for the closing
// fingers and the q_f as equal as that leaves them: least sum_f w_f (q_f - mean)^2 about their
// weighted mean. Throws std::invalid_argument if that does not determine the motion, or if some
// finger would have to open.
//
// If blocks join tendons that this leaves no common q, all sets of taut tendons are tried: of those
// whose tensions balance every block, t >= 0, one asks for the greatest q = t.motor / t.w. The tree
// jams if such tensions close no finger though motors pull. The others are slack, unless they
// would then be too short, by the same measure.
Motion motion(const Tree& tree, const std::map<int, Real>& weights);

}  // namespace reeve::testing::reference
