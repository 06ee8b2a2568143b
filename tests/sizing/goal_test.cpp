#include "sizing/goal.hpp"

#include <gtest/gtest.h>

#include "tests/support/input_error.hpp"

namespace reeve::testing {
namespace {

TEST(Goal, IsAnObjectiveOrAProduct) {
  EXPECT_EQ(to_text(parse_goal("uniformity * efficiency_worst")),
            "uniformity_mean x efficiency_worst");
  EXPECT_EQ(parse_goal("score").factors, std::vector{Objective::score});
  EXPECT_EQ(parse_goal("travel").better(), Better::lower);
  EXPECT_EQ(parse_goal("uniformity").better(), Better::higher);
}

TEST(Goal, IsRefusedWithWhatWasExpected) {
  EXPECT_EQ(input_error([] { parse_goal("sheaths"); }),
            "goal 'sheaths': 'sheaths' is a count, which no dimension changes");
  EXPECT_EQ(input_error([] { parse_goal("uniformity*travel"); }),
            "goal 'uniformity*travel': of 'travel' lower is better; expected objectives of which "
            "higher is better in a product");
  EXPECT_TRUE(input_error([] {
                parse_goal("uniformity*");
              }).starts_with("goal 'uniformity*': unknown objective ''; expected one of "));
}

TEST(Target, GivesSharesThatAddUpToOne) {
  EXPECT_EQ(parse_target("1=2,others=1", 3).target, (std::vector<double>{0.5, 0.25, 0.25}));
  EXPECT_EQ(parse_target("2=0.2, 1=0.6,3=0.2", 3).target.at(0), 0.6);
  EXPECT_EQ(parse_target("1=1000,2=0.001", 2).target.at(0), 1000 / 1000.001);
  EXPECT_TRUE(parse_target("1=1", 1).is_target());
  EXPECT_EQ(to_text(parse_target("1=2,2=1,3=1", 3)), "target shares 0.5, 0.25, 0.25");
}

TEST(Target, IsRefusedUnlessEachFingerHasOnePull) {
  for (const char* text :
       {"", "1=2", "1=2,2=1,2=1", "1=2,3=1", "1=0,2=1", "1=-1,2=1", "1=x,2=1", "1=2;2=1", "a=1,2=1",
        "others=1,others=2", "1=nan,2=1", "0=1,1=1,2=1", "1=0.0009,2=1", "1=1,2=1001"}) {
    EXPECT_EQ(input_error([&] { parse_target(text, 2); }),
              "target '" + std::string(text) +
                  "': expected a pull from 0.001 to 1000 for each of the 2 fingers once, such as "
                  "1=2,others=1");
  }
}

}  // namespace
}  // namespace reeve::testing
