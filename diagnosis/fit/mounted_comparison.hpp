// Differences between mountings of the same routing in the same group of rows.
//
// Residuals y in units of the readings' own noise; in each routing everything that its mountings
// have in common is taken out, whatever it is: the mean of each channel in each grasp and
// direction, a constant force, and how it follows load and speed; then what follows the cycle or
// the temperature at each kind of contact, and the order at each channel, since conditions differ
// between mountings too. With X a basis of that, V the loadings of what mountings change:
//
//   A = Vᵀ M V = diag(B_1, B_2, …) − S Sᵀ,   b = Vᵀ M y,   M = I − X X⁺
//
// with a block for each routing, and S of what all routings have in common.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

#include "diagnosis/fit/mounting.hpp"
#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

struct MountedEquations {
  std::vector<Eigen::MatrixXd> squares;  // B of each routing that is mounted more than once
  Eigen::MatrixXd shared;                // S
  Eigen::VectorXd along;                 // b
  std::vector<Mounted> kind;             // kind of each thing that a mounting changes
  std::size_t mounted_again = 0;         // mountings of a routing that was mounted before
};

MountedEquations mounted_equations(const Problem& problem, const Forecast& at,
                                   const MountingModes& modes);

}  // namespace reeve::diagnosis
