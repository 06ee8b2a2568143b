// Segments of a tree whose tension ratios are known, taken together.
#pragma once

#include <Eigen/LU>

#include <vector>

#include "tests/support/reference_tree.hpp"

namespace reeve::testing::reference {

// What a contact is known to do, in ln T_left - ln T_right.
struct Known {
  std::size_t contact;
  Real difference;
};

// Contacts that slide are at their bound, frictionless ones and bars have their ratio.
std::vector<Known> known_by_kinematics(const Tree& tree);

// T_i = t_g e^{rho_i} for the segments of group g; rho <= 0. No length passes between groups but
// through contacts that are not known, so that for each group
//
//   stretch_g t_g = elastic_g + imposed_g z + slips,   and for each block   sum_g pull_gb t_g = 0.
struct Groups {
  std::vector<Index> of;  // of each segment
  Vector rho;
  Vector stretch, elastic;
  Matrix imposed, pull;
};

// In that order; a contact between segments that are already in one group adds nothing.
Groups gather(const Tree& tree, const std::vector<Known>& known);

// A tree without blocks has no equations for them.
inline Vector solved_for_blocks(const Matrix& matrix, const Vector& right) {
  return matrix.rows() == 0 ? Vector() : Vector(matrix.fullPivLu().solve(right));
}

}  // namespace reeve::testing::reference
