#include "search/rank/infeasible.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "tests/search/generated.hpp"
#include "tests/search/naive_exploration.hpp"

namespace reeve::testing {
namespace {

std::vector<ConstraintReach> infeasible(const std::vector<std::string>& texts) {
  ExploreOptions options = options_for(full_parts(), 2);
  options.constraints = constraints_of(texts);
  return explore(options).infeasible;
}

TEST(Unmet, SaysTheNearestValuesOnBothSidesOfABound) {
  struct Case {
    const char* constraint;
    std::optional<double> below;
    std::optional<double> above;
  };
  for (const Case& expected : {Case{"sheaths<=0", {}, 1},
                               {"uniformity>=1", 0.9979088913, {}},  // TR7's
                               {"travel==1.5", 1.3333333333, 2},
                               // Nothing lies between: the bound itself is the nearest.
                               {"sheaths<1", 1, 1}}) {
    const std::vector<ConstraintReach> reaches = infeasible({expected.constraint});
    ASSERT_EQ(reaches.size(), 1U);
    EXPECT_FALSE(reaches[0].met);
    EXPECT_EQ(reaches[0].of_all.below, expected.below) << expected.constraint;
    EXPECT_EQ(reaches[0].of_all.above, expected.above) << expected.constraint;
  }
}

TEST(Unmet, LooksAtDesignsThatMeetTheOthers) {
  const std::vector<std::string> texts{"sheaths<=1", "uniformity>=0.995"};
  const std::vector<ConstraintReach> reaches = infeasible(texts);
  ASSERT_EQ(reaches.size(), 2U);
  const Naive all = naive_program(options_for(full_parts(), 2));
  double sheaths = 1e9;
  double uniformity = 0;
  for (const Design& design : all.kept) {
    const double u = value(design.values, Objective::uniformity_mean);
    const double s = value(design.values, Objective::sheaths);
    if (u >= 0.995) sheaths = std::min(sheaths, s);
    if (s <= 1) uniformity = std::max(uniformity, u);
  }
  EXPECT_TRUE(reaches[0].met && reaches[1].met);
  EXPECT_EQ(reaches[0].of_those_that_meet_the_others.above, sheaths);
  EXPECT_EQ(reaches[1].of_those_that_meet_the_others.below, uniformity);
}

TEST(Unmet, IsNothingWhereSomeDesignIsLeft) {
  EXPECT_TRUE(infeasible({"sheaths<=1"}).empty());
  EXPECT_TRUE(infeasible({}).empty());
}

}  // namespace
}  // namespace reeve::testing
