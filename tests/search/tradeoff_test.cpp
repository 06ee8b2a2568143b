#include "search/rank/tradeoff.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "tests/support/input_error.hpp"

namespace reeve::testing {
namespace {

Design design(const std::string& word, double sheaths, double uniformity, double efficiency = 0.5) {
  Design made{word, {}};
  value(made.values, Objective::sheaths) = sheaths;
  value(made.values, Objective::uniformity_mean) = uniformity;
  value(made.values, Objective::efficiency_mean) = efficiency;
  return made;
}

Tradeoff tradeoff_of(const std::vector<Design>& designs, double within = 0.02,
                     const Order& order = {}) {
  TradeoffArchive archive(order, Objective::sheaths);
  for (const Design& each : designs) archive.add(each);
  return tradeoff(archive.candidates(), rank(designs, order).front().design, order,
                  {Objective::sheaths, within});
}

std::string words(const Tradeoff& tradeoff) {
  std::string text;
  for (const TradeoffStep& step : tradeoff.steps) text += step.design.word + " ";
  return text;
}

TEST(Tradeoff, HasTheBestDesignForEachNumberAndNoStepWithoutGain) {
  const Tradeoff steps =
      tradeoff_of({design("A", 1, 0.5), design("B", 1, 0.4), design("C", 2, 0.8),
                   design("D", 3, 0.7), design("E", 4, 0.8), design("F", 5, 0.9)});
  EXPECT_EQ(words(steps), "A C F ");
  EXPECT_EQ(steps.steps[1].at_most, 2);
  EXPECT_EQ(steps.steps[0].kept, on_grid(0.5 / 0.9));
  EXPECT_EQ(steps.steps[2].kept, 1);
}

TEST(Tradeoff, KeepsWhatIsLeftInTheObjectiveThatLosesMost) {
  const Tradeoff steps = tradeoff_of({design("A", 1, 0.8, 0.3), design("B", 2, 0.9, 0.6)});
  EXPECT_NEAR(steps.steps[0].kept, 0.5, 1e-12);
}

// B is dominated and comes behind A in the ranking, whatever its score.
TEST(Tradeoff, HasNoStepThatAnotherOneWithLessDominates) {
  std::vector<Design> designs{design("A", 1, 0.9, 0.9), design("B", 2, 0.8, 0.8)};
  value(designs[1].values, Objective::score) = 5;
  const Order order({Objective::uniformity_mean, Objective::efficiency_mean}, true);
  EXPECT_EQ(words(tradeoff_of(designs, 0.02, order)), "A ");
}

// Heights above the chord: 2/3 - 1/3 at 2, 5/6 - 2/3 at 3 sheaths.
TEST(Knee, IsTheStepThatStandsHighestAboveTheChord) {
  const Tradeoff steps = tradeoff_of(
      {design("A", 1, 0.4), design("B", 2, 0.8), design("C", 3, 0.9), design("D", 4, 1.0)});
  ASSERT_TRUE(steps.knee);
  EXPECT_EQ(steps.steps[*steps.knee].design.word, "B");
}

TEST(Knee, ComesLaterWhereTheTradeoffIsSteepForLonger) {
  const Tradeoff steps = tradeoff_of(
      {design("A", 1, 0.4), design("B", 2, 0.6), design("C", 3, 0.98), design("D", 4, 1.0)});
  ASSERT_TRUE(steps.knee);
  EXPECT_EQ(steps.steps[*steps.knee].design.word, "C");
}

TEST(Knee, IsTheStepAboveTheChordAndNotTheFirstHighOne) {
  const Tradeoff steps = tradeoff_of(
      {design("A", 1, 0.4), design("B", 3, 0.7), design("C", 10, 0.94), design("D", 21, 1.0)});
  ASSERT_TRUE(steps.knee);
  EXPECT_EQ(steps.steps[*steps.knee].design.word, "C");
}

TEST(Knee, IsNoneOfAStraightOrASaggingOrAShortTradeoff) {
  EXPECT_FALSE(tradeoff_of({design("A", 1, 0.5), design("B", 2, 0.75), design("C", 3, 1.0)}).knee);
  EXPECT_FALSE(tradeoff_of({design("A", 1, 0.5), design("B", 2, 0.6), design("C", 3, 1.0)}).knee);
  EXPECT_FALSE(tradeoff_of({design("A", 1, 0.5), design("B", 9, 1.0)}).knee);
}

TEST(Affordable, HasLeastOfTheMeasureWithinTheLoss) {
  const std::vector<Design> designs{design("A", 1, 0.97), design("B", 2, 0.98),
                                    design("C", 3, 0.99), design("D", 4, 1.0)};
  EXPECT_EQ(tradeoff_of(designs, 0.02).affordable->word, "B");  // a loss of 2 % is within 2 %
  EXPECT_EQ(tradeoff_of(designs, 0.0199).affordable->word, "C");
  EXPECT_EQ(tradeoff_of(designs, 0.5).affordable->word, "A");
  EXPECT_FALSE(tradeoff_of(designs, 0).affordable);
}

TEST(Affordable, MustKeepEveryRankedObjective) {
  const std::vector<Design> designs{design("A", 1, 1.0, 0.4), design("B", 2, 0.99, 0.5),
                                    design("C", 3, 1.0, 0.5)};
  EXPECT_EQ(tradeoff_of(designs, 0.02).affordable->word, "B");
}

TEST(Affordable, NeedNotBeAStep) {
  // B has the greater product of those with one sheath, but only A keeps both objectives.
  const std::vector<Design> designs{design("A", 1, 0.98, 0.49), design("B", 1, 0.7, 0.8),
                                    design("C", 2, 1.0, 0.5), design("D", 2, 0.71, 0.81)};
  const Order order;
  TradeoffArchive archive(order, Objective::sheaths);
  for (const Design& each : designs) archive.add(each);
  const Tradeoff steps =
      tradeoff(archive.candidates(), designs[2], order, {Objective::sheaths, 0.02});
  EXPECT_EQ(steps.steps.front().design.word, "B");
  EXPECT_EQ(steps.affordable->word, "A");
}

TEST(Loss, IsRelativeToTheFirstWhicheverWayIsBetter) {
  const ObjectiveValues first = design("A", 4, 0.8).values;
  const ObjectiveValues other = design("B", 2, 0.6).values;
  EXPECT_NEAR(loss(Objective::uniformity_mean, other, first), 0.25, 1e-12);
  EXPECT_NEAR(loss(Objective::sheaths, other, first), -0.5, 1e-12);
  EXPECT_NEAR(loss(Objective::sheaths, first, other), 1, 1e-12);
  EXPECT_EQ(loss(Objective::jams, first, other), 0);
  ObjectiveValues jammed = first;
  value(jammed, Objective::jams) = 1;
  EXPECT_EQ(loss(Objective::jams, jammed, first), std::numeric_limits<double>::infinity());
  EXPECT_EQ(loss(Objective::jams, first, jammed), -1);
}

TEST(ParseWithin, ReadsPercents) {
  EXPECT_NEAR(parse_within("2%"), 0.02, 1e-15);
  EXPECT_NEAR(parse_within(" 2.5 % "), 0.025, 1e-15);
  EXPECT_EQ(parse_within("0%"), 0);
}

TEST(ParseWithinError, NamesTheTextAndWhatWasExpected) {
  for (const std::string text :
       {"", "2", "%", "0.02", "-1%", "100%", "nan%", "inf%", "2%%", "x%", "2 5%"}) {
    EXPECT_EQ(
        input_error([&] { parse_within(text); }),
        "within '" + text + "': expected a loss in percent, from 0% to below 100%, such as 2%");
  }
}

}  // namespace
}  // namespace reeve::testing
