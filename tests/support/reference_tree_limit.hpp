// The limit of a nearly inextensible tree of tendons in closed form, and its conditions.
#pragma once

#include "tests/support/reference_tree.hpp"

namespace reeve::testing::reference {

// T of each segment, in which all conditions are verified: every group's length, every cone, the
// direction of every slip, every block's balance, no tension below 0, and 0 only along a whole
// tendon that has more length than it needs (slack). Throws std::logic_error if none is found.
Vector tree_tensions(const Tree& tree);

}  // namespace reeve::testing::reference
