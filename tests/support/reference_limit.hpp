// The limit of a nearly inextensible tendon in closed form, and its optimality conditions.
#pragma once

#include "tests/support/reference_interior_point.hpp"

namespace reeve::testing::reference {

// Contacts at a bound tie segments into groups. No contact between groups carries a force, so
// each group balances by itself: sum L_i T_i = sum E_i.
// Gives u, once the optimality conditions hold; repairs sides that do not meet them. Throws
// std::logic_error if that fails.
Vector limit(const Problem& problem, Sides sides);

}  // namespace reeve::testing::reference
