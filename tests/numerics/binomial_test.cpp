#include "numerics/binomial.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace reeve {
namespace {

double at_least(int k, int n, double p) {
  double sum = 0;
  for (int i = k; i <= n; ++i) {
    sum += std::exp(std::lgamma(n + 1) - std::lgamma(i + 1) - std::lgamma(n - i + 1)) *
           std::pow(p, i) * std::pow(1 - p, n - i);
  }
  return sum;
}

// By definition each bound is the probability at which what was seen, or more extreme, has 2.5 %.
TEST(BinomialInterval, BoundsLeaveHalfOfTheRestInEachTail) {
  for (const int n : {1, 7, 50}) {
    for (const int k : {1, n / 2, n - 1}) {
      if (k < 1 || k >= n) continue;
      const ConfidenceInterval interval =
          binomial_interval(static_cast<std::size_t>(k), static_cast<std::size_t>(n));
      EXPECT_NEAR(at_least(k, n, interval.low), 0.025, 1e-9);
      EXPECT_NEAR(1 - at_least(k + 1, n, interval.high), 0.025, 1e-9);
    }
  }
}

TEST(BinomialInterval, OfAllOrNoneEndsAtOneOrZero) {
  const ConfidenceInterval none = binomial_interval(0, 20);
  EXPECT_EQ(none.low, 0);
  EXPECT_NEAR(none.high, 1 - std::pow(0.025, 1.0 / 20), 1e-12);
  const ConfidenceInterval all = binomial_interval(20, 20);
  EXPECT_NEAR(all.low, std::pow(0.025, 1.0 / 20), 1e-12);
  EXPECT_EQ(all.high, 1);
}

TEST(BinomialInterval, WithoutTrialsIsEverything) {
  const ConfidenceInterval interval = binomial_interval(0, 0);
  EXPECT_EQ(interval.low, 0);
  EXPECT_EQ(interval.high, 1);
}

TEST(SoManySuccesses, AreAsRareAsTheirTermsAddUpTo) {
  for (const int n : {1, 7, 50}) {
    for (int k = 0; k <= n; k += 3) {
      const double chance =
          at_least_so_many(static_cast<std::size_t>(k), static_cast<std::size_t>(n), 0.13);
      EXPECT_NEAR(chance, at_least(k, n, 0.13), 1e-12) << k << " of " << n;
    }
  }
  EXPECT_EQ(at_least_so_many(3, 2, 0.5), 0);
}

}  // namespace
}  // namespace reeve
