// How far all dimensions may be off at once, against closed forms and dense grids.
#include "sizing/joint_tolerance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sizing/sizing_of.hpp"

namespace reeve::testing {
namespace {

struct Evaluated {
  SizingOptions options;
  SizingProblem problem;
  std::vector<double> point;
  std::vector<Sensitivity> alone;
  JointTolerance together;

  Evaluated(const std::string& word, SizingOptions given, std::vector<double> at)
      : options(std::move(given)),
        problem(parse_routing(word), options),
        point(std::move(at)),
        alone(sensitivities(problem, options.goal, point)),
        together(joint_tolerance(problem, options.goal, point, alone, options.seed)) {}

  double lost(const std::vector<double>& there) const {
    return (problem.loss(there) - problem.loss(point)) / tolerated(problem, options.goal, point);
  }

  // The greatest part of what is tolerated that is lost in the box of that factor, on a grid of two
  // variables.
  double greatest_loss(double factor, int steps) const {
    double greatest = 0;
    const auto at = [&](std::size_t i, int k) {
      const double share = 2.0 * k / steps - 1;
      const JointTolerance::Ways& ways = together.ways[i];
      const double way = (share < 0 ? ways.less : ways.more) / together.factor;
      return point[i] + factor * share * way;
    };
    for (int i = 0; i <= steps; ++i) {
      for (int k = 0; k <= steps; ++k) {
        greatest = std::max(greatest, lost({at(0, i), at(1, k)}));
      }
    }
    return greatest;
  }
};

// In M-1-T-2-F the uniformity is T4/T1 = e^{−μ(θ1 + θ2 + θ3)}: alone each angle may grow by
// −ln(0.99)/μ, together by a third of it.
TEST(JointTolerance, OfThreeAnglesOfOneTendonIsAThird) {
  SizingOptions options = sizing(
      "uniformity",
      {"contact_angle[T1-T2]=1..2", "contact_angle[T2-T3]=1..2", "contact_angle[T3-T4]=1..2"});
  options.grasps = parse_grasps("none", 2);
  const Evaluated evaluated("M-1-T-2-F", options, {1, 1, 1});
  const double alone = -std::log(0.99) / 0.18;
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(evaluated.alone[i].more);
    EXPECT_NEAR(*evaluated.alone[i].more, alone, 1e-9);
    EXPECT_FALSE(evaluated.alone[i].less);
    EXPECT_NEAR(evaluated.together.ways[i].more, alone / 3, 1e-8);
    // Less costs nothing, however much: it is told as much as more.
    EXPECT_NEAR(evaluated.together.ways[i].less, alone / 3, 1e-8);
    EXPECT_NEAR(evaluated.together.worst[i], alone / 3, 1e-8);
  }
  EXPECT_NEAR(evaluated.together.factor, 1.0 / 3, 1e-8);
}

TEST(JointTolerance, OfOneDimensionIsItsOwn) {
  SizingOptions options = sizing("uniformity", {"contact_angle[T2-T3]=1..2"});
  const Evaluated evaluated("M-1-T-2-F", options, {1});
  EXPECT_EQ(evaluated.together.factor, 1);
  EXPECT_EQ(evaluated.together.ways[0].more, *evaluated.alone[0].more);
  EXPECT_TRUE(evaluated.together.worst.empty());
}

// No friction depends on a length.
TEST(JointTolerance, OfDimensionsThatDoNothingIsATenthOfTheirBounds) {
  SizingOptions options = sizing("efficiency", {"strand_mm=50..90"});
  const Evaluated evaluated("1-P-2-P-1", options, {70, 70});
  EXPECT_EQ(evaluated.together.factor, 1);
  for (const JointTolerance::Ways& ways : evaluated.together.ways) {
    EXPECT_NEAR(ways.less, 4, 1e-12);
    EXPECT_NEAR(ways.more, 4, 1e-12);
  }
}

TEST(JointTolerance, OfTwoDimensionsIsThatOfADenseGrid) {
  for (const char* goal : {"uniformity_worst", "torsional_balance*efficiency_worst"}) {
    SCOPED_TRACE(goal);
    SizingOptions options = sizing(goal, {"sheath_angle=3..9"});
    options.robust = true;
    options.draws = 15;
    const SizedDesign design = sized("M-1-P-2-M", options);
    const Evaluated evaluated("M-1-P-2-M", options, values_of(design));
    EXPECT_LE(evaluated.greatest_loss(evaluated.together.factor, 40), 1 + 1e-6);
    if (evaluated.together.factor < 1) {
      EXPECT_GT(evaluated.greatest_loss(1.01 * evaluated.together.factor, 40), 1);
    }
    ASSERT_TRUE(design.together);
    EXPECT_EQ(design.together->factor, evaluated.together.factor);
  }
}

TEST(JointTolerance, OfATargetIsThatOfADenseGrid) {
  const SizingOptions options = aiming("1=0.6,2=0.4", {"sheath_angle=2..11"});
  const SizedDesign design = sized("M-1-P-2-M", options);
  const Evaluated evaluated("M-1-P-2-M", options, values_of(design));
  EXPECT_LT(evaluated.together.factor, 1);
  EXPECT_LE(evaluated.greatest_loss(evaluated.together.factor, 60), 1 + 1e-6);
  EXPECT_GT(evaluated.greatest_loss(1.01 * evaluated.together.factor, 60), 1);
}

// Nine contacts, each of which takes its e^{−μθ}: more corners than are looked at one by one.
TEST(JointTolerance, OfManyDimensionsIsFoundByAscent) {
  std::vector<std::string> varied;
  for (const char* contact :
       {"T1-T2", "T2-T3", "T3-T4", "T4-T5", "T5-T6", "T6-T7", "T7-T8", "T8-T9", "T9-T10"}) {
    varied.push_back(std::string("contact_angle[") + contact + "]=1..2");
  }
  SizingOptions options = sizing("uniformity", varied, 5);
  options.grasps = parse_grasps("none", 5);
  const Evaluated evaluated("M-1-T-2-T-3-T-4-T-5-F", options, std::vector<double>(9, 1));
  EXPECT_NEAR(evaluated.together.factor, 1.0 / 9, 1e-7);
}

TEST(JointTolerance, IsTheSameWithTheSameSeed) {
  SizingOptions options = sizing("uniformity*efficiency", {"sheath_angle=3..9", "tip_angle=1..4"});
  const SizedDesign one = sized("M-1-P-2-M", options);
  options.threads = 4;
  const SizedDesign other = sized("M-1-P-2-M", options);
  EXPECT_EQ(one.together->factor, other.together->factor);
}

}  // namespace
}  // namespace reeve::testing
