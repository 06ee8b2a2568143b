// Functions of dense matrices: axes, ranks, bases and solutions. They wrap Eigen's decompositions
// so that each is compiled once.
#pragma once

#include <Eigen/Core>

#include <optional>

#include "numerics/floors.hpp"

namespace reeve::numerics {

// A = V Λ Vᵀ of a symmetric A, of which the lower half is read.
struct SymmetricAxes {
  Eigen::VectorXd values;   // Λ, ascending
  Eigen::MatrixXd vectors;  // V, one a column
};
SymmetricAxes symmetric_axes(const Eigen::MatrixXd& symmetric);

// Solves A x = right for a symmetric positive semidefinite A, by LDLᵀ.
Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& symmetric, const Eigen::VectorXd& right);
Eigen::MatrixXd inverse_of_symmetric(const Eigen::MatrixXd& symmetric);

// Uses QR with pivoting. Pivots up to `threshold` times the largest count as 0; the default is the
// rounding error of a matrix of this size.
Eigen::Index column_rank(const Eigen::MatrixXd& matrix);
// An orthonormal basis of what the columns span.
Eigen::MatrixXd orthonormal_columns(const Eigen::MatrixXd& columns,
                                    std::optional<double> threshold = std::nullopt);

// The shortest x of those that bring A x nearest to the right-hand side.
Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace reeve::numerics
