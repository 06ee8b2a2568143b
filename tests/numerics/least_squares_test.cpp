#include "numerics/least_squares.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
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

// a e^{-b t} + c, read with a little noise: nearly the least, with fewer evaluations.
TEST(LeastSquares, ToCompareCorrectsTheJacobianByItsSteps) {
  int evaluations = 0;
  const auto decay = [&](const std::vector<double>& x) -> std::optional<VectorXd> {
    ++evaluations;
    VectorXd left(40);
    for (int i = 0; i < 40; ++i) {
      const double t = 0.1 * i;
      const double read = 3 * std::exp(-0.7 * t) + 1 + 0.05 * std::sin(37.0 * i);
      left[i] = x[0] * std::exp(-x[1] * t) + x[2] - read;
    }
    return left;
  };
  const std::vector<Interval> box{{0, 10}, {0, 5}, {-5, 5}};
  const LeastSquares full = least_squares(decay, box, {1, 2, 0});
  const int of_full = std::exchange(evaluations, 0);
  const LeastSquares quick = least_squares(decay, box, {1, 2, 0}, Precision::to_compare);
  EXPECT_TRUE(quick.converged);
  EXPECT_LT(evaluations, of_full);
  EXPECT_NEAR(quick.minimum.value, full.minimum.value, 1e-2 * full.minimum.value);
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
