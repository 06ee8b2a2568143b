// Which contacts of a tree are at a bound, by the reference model.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tests/support/reference_tree.hpp"

namespace reeve::testing::reference {

struct Verdict {
  std::size_t contact;
  int side;        // +1: ln T_left - ln T_right = phi; -1: = -phi; 0: inside
  Real certainty;  // ln of what there is of slip for what there is of room
};

// Of the contacts that the kinematics leaves open. Primal-dual path-following for the whole system,
// cones, lengths and balances of blocks together: with the groups of reference_groups.hpp,
// T_g = e^{u_g}, rooms q, p = phi +- d and slips s+, s- to the right and to the left
//
//   stretch_g T_g = elastic_g + imposed_g z + (s+ - s-) in - out,   q s+ = p s- = tau -> 0,
//   ln (sum of strands and beckets) = ln (sum of tails) at each block.
//
// Where it does not converge, the verdicts are those of the last step: the conditions of the limit
// decide. There are none where a tendon goes slack.
std::optional<std::vector<Verdict>> open_contacts(const Tree& tree);

}  // namespace reeve::testing::reference
