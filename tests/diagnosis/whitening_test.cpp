// Shared scatter against the covariance that it stands for.
#include "diagnosis/fit/whitening.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace reeve::testing {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd loadings() {
  MatrixXd v(4, 2);
  v << 1, 0.5, 2, -0.3, 0, 0.7, -1, 0.2;
  return v;
}

// On cells 1, 2, 4, 5 of six.
Whitening of_four_cells() { return {shared_scatter({1, 2, 4, 5}, loadings(), loadings())}; }

MatrixXd covariance() {
  const std::vector<Index> cells{1, 2, 4, 5};
  MatrixXd all = MatrixXd::Identity(6, 6);
  const MatrixXd shared = loadings() * loadings().transpose();
  for (Index i = 0; i < 4; ++i) {
    for (Index j = 0; j < 4; ++j) {
      all(cells[static_cast<std::size_t>(i)], cells[static_cast<std::size_t>(j)]) += shared(i, j);
    }
  }
  return all;
}

TEST(Whitening, MakesResidualsIndependent) {
  MatrixXd root = MatrixXd::Identity(6, 6);
  const Whitening whitening = of_four_cells();
  whiten(whitening, root);
  EXPECT_LT((root * covariance() * root.transpose() - MatrixXd::Identity(6, 6)).norm(), 1e-10);
}

TEST(Whitening, OfNothingSharedChangesNothing) {
  VectorXd residuals = VectorXd::LinSpaced(6, -1, 1);
  const VectorXd before = residuals;
  const Whitening nothing{shared_scatter({1, 2, 4, 5}, 0 * loadings(), 0 * loadings())};
  whiten(nothing, residuals);
  EXPECT_EQ(residuals, before);
}

// 20 000 draws: the error of a covariance of about 5 is some 0.05.
TEST(Whitening, DrawsWhatItTakesOut) {
  constexpr int draws = 20000;
  const Whitening whitening = of_four_cells();
  MatrixXd found = MatrixXd::Zero(6, 6);
  for (int d = 0; d < draws; ++d) {
    VectorXd drawn = VectorXd::Zero(6);
    add_shared_draws(whitening, 11, static_cast<std::uint32_t>(d), 0, drawn);
    found += drawn * drawn.transpose() / draws;
  }
  EXPECT_LT((found - covariance() + MatrixXd::Identity(6, 6)).cwiseAbs().maxCoeff(), 0.2);
}

}  // namespace
}  // namespace reeve::testing
