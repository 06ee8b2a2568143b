#include "numerics/robust.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace reeve::testing {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

TEST(Median, IgnoresMissingNumbers) {
  EXPECT_EQ(median({3, 1, missing, 2}), 2);
  EXPECT_EQ(median({4, 1, 1e9, 2}), 3);
  EXPECT_TRUE(std::isnan(median({missing})));
}

TEST(Quantile, LiesBetweenTwoNumbersByTheShare) {
  EXPECT_EQ(quantile_of({4, 0, 2, 6, 8}, 0.75), 6);
  EXPECT_DOUBLE_EQ(quantile_of({0, 10}, 0.3), 3);
  EXPECT_EQ(quantile_of({5, 1}, 1), 5);
}

// 0.6745 is the middle of the absolute values of standard normal numbers.
TEST(Deviation, IsScaledToNormalNumbers) {
  EXPECT_DOUBLE_EQ(mad_about_zero({-0.6745, 0.1, 2 * 0.6745, 0.6745, -99}), 1);
  EXPECT_EQ(mad_about_zero({}), 0);
}

TEST(Deviation, AboutATrendLeavesTheTrendOut) {
  EXPECT_EQ(deviation_about_trend({{1, 2, 3, 4}, {9, 7, 5}}), 0);
  const double step = 0.6745 * std::sqrt(6.0);  // one second difference of it, and one of 0
  EXPECT_DOUBLE_EQ(deviation_about_trend({{0, 0, step, 2 * step}, {5, 5}, {}}), 0.5);
}

}  // namespace
}  // namespace reeve::testing
