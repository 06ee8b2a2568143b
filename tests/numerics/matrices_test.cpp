#include "numerics/matrices.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace reeve {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd matrix_of(Eigen::Index rows, Eigen::Index cols, std::initializer_list<double> by_row) {
  MatrixXd result(rows, cols);
  auto value = by_row.begin();
  for (Eigen::Index r = 0; r < rows; ++r) {
    for (Eigen::Index c = 0; c < cols; ++c) result(r, c) = *value++;
  }
  return result;
}

VectorXd vector_of(std::initializer_list<double> values) {
  return matrix_of(static_cast<Eigen::Index>(values.size()), 1, values);
}

TEST(Matrices, AxesOfTwoCoupledSprings) {
  const SymmetricAxes axes = symmetric_axes(matrix_of(2, 2, {2, 1, 1, 2}));
  EXPECT_NEAR(axes.values[0], 1, 1e-14);
  EXPECT_NEAR(axes.values[1], 3, 1e-14);
  EXPECT_NEAR(axes.vectors(0, 0), -axes.vectors(1, 0), 1e-14);
  EXPECT_NEAR(axes.vectors(0, 1), axes.vectors(1, 1), 1e-14);
  EXPECT_NEAR(axes.vectors.col(1).norm(), 1, 1e-14);
}

TEST(Matrices, SymmetricOnesAreSolvedAndInverted) {
  const MatrixXd a = matrix_of(3, 3, {4, 1, 0, 1, 3, 1, 0, 1, 2});
  const VectorXd x = solve_symmetric(a, a * vector_of({1, -2, 3}));
  EXPECT_LT((x - vector_of({1, -2, 3})).norm(), 1e-13);
  EXPECT_LT((inverse_of_symmetric(a) * a - MatrixXd::Identity(3, 3)).norm(), 1e-13);
}

TEST(Matrices, RankIsThatOfIndependentColumns) {
  EXPECT_EQ(column_rank(matrix_of(3, 2, {1, 2, 2, 4, 3, 6})), 1);
  EXPECT_EQ(column_rank(matrix_of(3, 2, {1, 2, 2, 4, 3, 7})), 2);
  EXPECT_EQ(column_rank(MatrixXd::Zero(3, 2)), 0);
}

TEST(Matrices, BasisSpansWhatTheColumnsDo) {
  const MatrixXd columns = matrix_of(3, 3, {1, 2, 0, 2, 4, 1, 3, 6, 1});
  const MatrixXd basis = orthonormal_columns(columns);
  ASSERT_EQ(basis.cols(), 2);
  EXPECT_LT((basis.transpose() * basis - MatrixXd::Identity(2, 2)).norm(), 1e-14);
  EXPECT_LT((columns - basis * (basis.transpose() * columns)).norm(), 1e-13);
}

TEST(Matrices, ThresholdSaysWhatCountsAsNone) {
  const MatrixXd columns = matrix_of(2, 2, {1, 1, 0, 1e-3});
  EXPECT_EQ(orthonormal_columns(columns).cols(), 2);
  EXPECT_EQ(orthonormal_columns(columns, 1e-2).cols(), 1);
}

TEST(Matrices, LeastNormSolutionIsTheShortestOfTheNearest) {
  const VectorXd shared = least_norm_solution(matrix_of(1, 2, {1, 1}), vector_of({2}));
  EXPECT_NEAR(shared[0], 1, 1e-14);
  EXPECT_NEAR(shared[1], 1, 1e-14);
  const VectorXd mean = least_norm_solution(matrix_of(3, 1, {1, 1, 1}), vector_of({1, 2, 6}));
  EXPECT_NEAR(mean[0], 3, 1e-14);
}

}  // namespace
}  // namespace reeve
