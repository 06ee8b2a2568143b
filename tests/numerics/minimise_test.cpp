#include "numerics/minimise.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace reeve {
namespace {

TEST(Minimise, FindsTheBottomOfABowl) {
  const Minimum found = minimise(
      [](const std::vector<double>& x) {
        return std::pow(x[0] - 0.3, 2) + 2 * std::pow(x[1] + 1.7, 2) + 5;
      },
      {{-1, 2}, {-3, 3}}, 2000);
  EXPECT_NEAR(found.at[0], 0.3, 1e-6);
  EXPECT_NEAR(found.at[1], -1.7, 1e-6);
  EXPECT_NEAR(found.value, 5, 1e-12);
}

TEST(Minimise, FindsACornerOfTheBox) {
  const Minimum found = minimise([](const std::vector<double>& x) { return x[0] - 3 * x[1]; },
                                 {{0.05, 0.2}, {1, 4}}, 1000);
  EXPECT_NEAR(found.at[0], 0.05, 1e-6);
  EXPECT_NEAR(found.at[1], 4, 1e-5);
}

TEST(Minimise, IsNotCaughtInTheWrongValleyOfAKinkedFunction) {
  const auto two_valleys = [](const std::vector<double>& x) {
    return std::min(std::abs(x[0] - 0.2) + 0.1, 4 * std::abs(x[0] - 0.9));
  };
  const Minimum found = minimise(two_valleys, {{0, 1}}, 500);
  EXPECT_NEAR(found.at[0], 0.9, 1e-6);
  EXPECT_NEAR(found.value, 0, 1e-5);
}

TEST(Minimise, LeavesFixedVariablesAlone) {
  const auto distance = [](const std::vector<double>& x) {
    return std::abs(x[0] - 5) + std::abs(x[1] - 0.5);
  };
  EXPECT_EQ(minimise(distance, {{2, 2}, {0, 1}}, 500).at[0], 2);
  const Minimum nothing_free = minimise(distance, {{2, 2}, {1, 1}}, 500);
  EXPECT_EQ(nothing_free.at, (std::vector<double>{2, 1}));
  EXPECT_EQ(nothing_free.value, 3.5);
}

TEST(Minimise, GivesTheSameAnswerEveryTime) {
  const auto wavy = [](const std::vector<double>& x) { return std::sin(9 * x[0]) * x[1]; };
  const Minimum first = minimise(wavy, {{0, 3}, {0, 1}}, 300);
  const Minimum second = minimise(wavy, {{0, 3}, {0, 1}}, 300);
  EXPECT_EQ(first.at, second.at);
  EXPECT_EQ(first.value, second.value);
}

TEST(Minimise, LetsExceptionsThrough) {
  EXPECT_THROW(minimise([](const std::vector<double>&) -> double { throw std::domain_error("x"); },
                        {{0, 1}}, 10),
               std::domain_error);
}

// From the middle of the box it would go to the other valley.
TEST(Refine, GoesDownhillFromWhereItBegins) {
  const auto two_valleys = [](const std::vector<double>& x) {
    return std::min(std::pow(x[0] - 0.2, 2) + 0.1, 4 * std::pow(x[0] - 0.9, 2));
  };
  EXPECT_NEAR(refine(two_valleys, {{0, 1}}, {0.15}, 200).at[0], 0.2, 1e-4);
  EXPECT_NEAR(refine(two_valleys, {{0, 1}}, {0.95}, 200).at[0], 0.9, 1e-4);
}

TEST(Descend, GoesOverAShallowRidgeButNotAHighOne) {
  const auto two_valleys = [](double ridge) {
    return [ridge](const std::vector<double>& x) {
      return std::min(std::abs(x[0] - 0.2) + ridge, 4 * std::abs(x[0] - 0.9));
    };
  };
  EXPECT_NEAR(descend(two_valleys(0), {{0, 1}}, {0.2}, 500).at[0], 0.2, 1e-6);
  EXPECT_NEAR(descend(two_valleys(0.5), {{0, 1}}, {0.7}, 500).at[0], 0.9, 1e-6);
}

TEST(FromAStart, FixedVariablesAreLeftAlone) {
  const auto bowl = [](const std::vector<double>& x) {
    return std::pow(x[0] - 5, 2) + std::pow(x[1] - 0.5, 2);
  };
  for (const Minimum& found : {descend(bowl, {{2, 2}, {0, 1}}, {2, 0}, 500),
                               refine(bowl, {{2, 2}, {0, 1}}, {2, 0}, 500)}) {
    EXPECT_EQ(found.at[0], 2);
    EXPECT_NEAR(found.at[1], 0.5, 1e-4);
  }
}

TEST(Descend, EndsWhereItsStepsAreAsSmallAsAsked) {
  int calls = 0;
  const auto distance = [&](const std::vector<double>& x) {
    ++calls;
    return std::abs(x[0] - 0.3) + std::abs(x[1] - 0.6);
  };
  EXPECT_NEAR(descend(distance, {{0, 1}, {0, 1}}, {1, 0}, 2000, 1e-2).at[0], 0.3, 0.05);
  const int coarse = std::exchange(calls, 0);
  EXPECT_NEAR(descend(distance, {{0, 1}, {0, 1}}, {1, 0}, 2000).at[1], 0.6, 1e-7);
  EXPECT_LT(coarse, calls);
}

TEST(Stopping, EndsASearchWithTheBestItHasSeen) {
  std::atomic<bool> stop{false};
  int calls = 0;
  const auto counted = [&](const std::vector<double>& x) {
    if (++calls == 20) stop = true;
    return std::pow(x[0] - 0.3, 2);
  };
  const Minimum found = minimise(counted, {{0, 1}}, 100000, &stop);
  EXPECT_EQ(calls, 20);
  EXPECT_EQ(found.value, std::pow(found.at[0] - 0.3, 2));
  // Set before, it leaves one look at the start.
  calls = 0;
  EXPECT_EQ(descend(counted, {{0, 1}}, {0.7}, 1000, 1e-9, &stop).at[0], 0.7);
  EXPECT_EQ(calls, 1);
}

TEST(Refine, BeginsWithinTheBox) {
  const auto distance = [](const std::vector<double>& x) { return std::pow(x[0] - 7, 2); };
  EXPECT_NEAR(refine(distance, {{0, 1}}, {5}, 100).at[0], 1, 1e-6);
}

}  // namespace
}  // namespace reeve
