#include "pages/objective_plot.hpp"

#include <gtest/gtest.h>

#include "core/notation.hpp"
#include "pages/exploration/exploration_designs.hpp"
#include "search/evaluate/evaluation.hpp"

namespace reeve {
namespace {

TEST(ObjectiveAxis, OfAShareRunsFromZeroToOne) {
  const chart::Axis axis = objective_axis(Objective::efficiency_worst);
  EXPECT_EQ(axis.least, 0);
  EXPECT_EQ(axis.greatest, 1);
  EXPECT_FALSE(axis.whole);
}

TEST(ObjectiveAxis, OfAnIndicatorReachesTen) {
  for (const Objective objective : {Objective::adaptability, Objective::torsional_balance}) {
    EXPECT_EQ(objective_axis(objective).least, 0);
    EXPECT_EQ(objective_axis(objective).greatest, 10);
  }
}

// A tackle of three parts pulls three times as hard as the motor.
TEST(ObjectiveAxis, OfARatioOfForcesHasNoEnd) {
  Hardware smooth;
  smooth.sheath.mu = 0;
  smooth.bearing.mu = 0;
  const ObjectiveValues values = DesignEvaluator(smooth, parse_grasps("none", 1))
                                     .evaluate(parse_routing("M-B-Y1-B-Y1k+Y1-1x"));
  EXPECT_NEAR(value(values, Objective::transmission), 30, 1e-9);
  for (const Objective objective : {Objective::transmission, Objective::force_transmission}) {
    EXPECT_EQ(objective_axis(objective).least, 0);
    EXPECT_EQ(objective_axis(objective).greatest, std::nullopt);
  }
}

// A friction force may be greater than all strand tensions together, and in a score an objective of
// which less is better counts negative.
TEST(ObjectiveAxis, LeavesRoomBelowZero) {
  EXPECT_EQ(objective_axis(Objective::reliability).least, std::nullopt);
  EXPECT_EQ(objective_axis(Objective::reliability).greatest, 10);
  EXPECT_EQ(objective_axis(Objective::score).least, std::nullopt);
  EXPECT_EQ(objective_axis(Objective::score).greatest, std::nullopt);
}

TEST(ObjectiveAxis, OfCountsHasWholeNumbersWithoutEnd) {
  for (const Objective objective :
       {Objective::jams, Objective::sheaths, Objective::pulleys, Objective::knots}) {
    EXPECT_TRUE(objective_axis(objective).whole);
    EXPECT_EQ(objective_axis(objective).least, 0);
    EXPECT_EQ(objective_axis(objective).greatest, std::nullopt);
  }
}

TEST(ObjectiveAxis, IsLimitedAlikeInTheDrawingAndInThePlotOfTheScript) {
  const Json list = objectives_json(
      {Objective::uniformity_mean, Objective::reliability, Objective::authors_efficiency});
  EXPECT_EQ(list[0]["least"], 0);
  EXPECT_EQ(list[0]["greatest"], 1);
  EXPECT_EQ(list[1]["least"], nullptr);
  EXPECT_EQ(list[1]["greatest"], 10);
  EXPECT_EQ(list[2]["least"], 0);
  EXPECT_EQ(list[2]["greatest"], nullptr);
}

}  // namespace
}  // namespace reeve
