#include "search/rank/infeasible.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/search/naive_exploration.hpp"

namespace reeve::testing {
namespace {

std::vector<ConstraintReach> infeasible(const std::vector<std::string>& texts, int fingers = 2) {
  ExploreOptions options = options_for(full_parts(), fingers);
  for (const std::string& text : texts) options.constraints.push_back(parse_constraint(text));
  return explore(options).infeasible;
}

TEST(Unmet, SaysTheLeastOfAnUpperBoundThatNothingMeets) {
  const std::vector<ConstraintReach> reaches = infeasible({"sheaths<=0"});
  ASSERT_EQ(reaches.size(), 1U);
  EXPECT_FALSE(reaches[0].met);
  EXPECT_EQ(reaches[0].of_all.above, 1);
  EXPECT_FALSE(reaches[0].of_all.below);
}

TEST(Unmet, SaysTheGreatestOfALowerBound) {
  const std::vector<ConstraintReach> reaches = infeasible({"uniformity>=1"});
  ASSERT_EQ(reaches.size(), 1U);
  EXPECT_EQ(reaches[0].of_all.below, 0.9979088913);  // TR7's
  EXPECT_FALSE(reaches[0].of_all.above);
}

TEST(Unmet, SaysBothNeighboursOfAnEquality) {
  const std::vector<ConstraintReach> reaches = infeasible({"travel==1.5"});
  ASSERT_EQ(reaches.size(), 1U);
  EXPECT_EQ(reaches[0].of_all.below, 1.3333333333);
  EXPECT_EQ(reaches[0].of_all.above, 2);
}

// Nothing lies between; the bound itself is the nearest that does not meet it.
TEST(Unmet, TakesTheBoundItselfOfAStrictComparison) {
  EXPECT_EQ(infeasible({"sheaths<1"})[0].of_all.above, 1);
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

TEST(Unmet, IsTheSameForAnyNumberOfThreads) {
  ExploreOptions options = several_batches();
  options.constraints = {parse_constraint("sheaths<=1"), parse_constraint("uniformity>=0.98")};
  const std::vector<ConstraintReach> one = explore(options).infeasible;
  options.threads = 3;
  const std::vector<ConstraintReach> three = explore(options).infeasible;
  ASSERT_EQ(one.size(), 2U);
  ASSERT_EQ(three.size(), 2U);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(one[c].of_all.above, three[c].of_all.above);
    EXPECT_EQ(one[c].of_those_that_meet_the_others.below,
              three[c].of_those_that_meet_the_others.below);
  }
}

}  // namespace
}  // namespace reeve::testing
