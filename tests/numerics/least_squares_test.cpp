#include "numerics/least_squares.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace reeve::testing {
namespace {

using Eigen::VectorXd;

// J. J. Moré, B. S. Garbow, K. E. Hillstrom, ACM TOMS 7, 1981, problem 1: least at (1, 1).
std::optional<VectorXd> rosenbrock(const std::vector<double>& x) {
  return VectorXd{{10 * (x[1] - x[0] * x[0]), 1 - x[0]}};
}

TEST(LeastSquares, FollowsACurvedValley) {
  const LeastSquares found = least_squares(&rosenbrock, {{-3, 3}, {-3, 3}}, {-1.2, 1});
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.minimum.at[0], 1, 1e-5);
  EXPECT_NEAR(found.minimum.at[1], 1, 1e-5);
}

// The least in the box lies on its side: x0 = 0.5, x1 = x0². Beyond it nothing is evaluated.
TEST(LeastSquares, StopsAtTheSideOfTheBox) {
  double farthest = -3;
  const auto watched = [&](const std::vector<double>& x) {
    farthest = std::max(farthest, x[0]);
    return rosenbrock(x);
  };
  const LeastSquares found = least_squares(watched, {{-3, 0.5}, {-3, 3}}, {-1.2, 1});
  EXPECT_TRUE(found.converged);
  EXPECT_DOUBLE_EQ(found.minimum.at[0], 0.5);
  EXPECT_NEAR(found.minimum.at[1], 0.25, 1e-5);
  EXPECT_EQ(farthest, 0.5);
}

TEST(LeastSquares, GoesAroundWhereThereAreNoResiduals) {
  const auto holes = [](const std::vector<double>& x) -> std::optional<VectorXd> {
    if (x[0] > 2) return std::nullopt;
    return VectorXd{{std::exp(x[0]) - std::exp(1.9)}};
  };
  const LeastSquares found = least_squares(holes, {{-5, 5}}, {0});
  EXPECT_NEAR(found.minimum.at[0], 1.9, 1e-5);
}

TEST(LeastSquares, SaysThatAKinkStopsIt) {
  const auto kink = [](const std::vector<double>& x) -> std::optional<VectorXd> {
    return VectorXd{{1 + std::sqrt(std::abs(x[0] - 0.3))}};
  };
  EXPECT_FALSE(least_squares(kink, {{-1, 1}}, {0.29999}).converged);
}

}  // namespace
}  // namespace reeve::testing
