#include "numerics/matrices.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace reeve::numerics {

using Eigen::MatrixXd;
using Eigen::VectorXd;

SymmetricAxes symmetric_axes(const MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

VectorXd solve_symmetric(const MatrixXd& symmetric, const VectorXd& right) {
  return symmetric.ldlt().solve(right);
}

MatrixXd inverse_of_symmetric(const MatrixXd& symmetric) {
  return symmetric.ldlt().solve(MatrixXd::Identity(symmetric.rows(), symmetric.cols()));
}

Eigen::Index column_rank(const MatrixXd& matrix) {
  return Eigen::ColPivHouseholderQR<MatrixXd>(matrix).rank();
}

MatrixXd orthonormal_columns(const MatrixXd& columns, std::optional<double> threshold) {
  Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
  if (threshold) qr.setThreshold(*threshold);
  return qr.householderQ() * MatrixXd::Identity(columns.rows(), qr.rank());
}

VectorXd least_norm_solution(const MatrixXd& matrix, const VectorXd& right) {
  return matrix.completeOrthogonalDecomposition().solve(right);
}

}  // namespace reeve::numerics
