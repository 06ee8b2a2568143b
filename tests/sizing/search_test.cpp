// What is found, against what a dense grid and blind probing find, with the goal computed apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>

#include "catalog/hardware_file.hpp"
#include "core/mechanics.hpp"
#include "core/tension/tension.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/uncertainty/uncertainty.hpp"
#include "tests/sizing/sizing_of.hpp"
#include "tests/support/sanitizers.hpp"

namespace reeve::testing {
namespace {

// Sheath angles of the fingers 1, 2, …
Hardware with_sheaths(Hardware hardware, const std::vector<double>& angles, double factor = 1) {
  hardware.fingers.clear();
  for (std::size_t f = 0; f < angles.size(); ++f) {
    hardware.fingers.push_back({static_cast<int>(f) + 1, {}, {}, {}, angles[f] * factor, {}, 1});
  }
  return hardware;
}

double product(const std::string& word, const Hardware& hardware) {
  return uniformity_times_efficiency(
      DesignEvaluator(hardware, single_grasps(2)).evaluate(parse_routing(word)));
}

double miss(const std::string& word, const Hardware& hardware, const std::vector<double>& target) {
  const Network network = expand(parse_routing(word));
  const TensionState state = tensions(network, mechanics(network, hardware), Grasp{});
  std::vector<double> pull(target.size(), 0);
  double sum = 0;
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    if (network.segments[i].kind != SegmentKind::strand) continue;
    pull[static_cast<std::size_t>(network.segments[i].finger) - 1] += state.tension[i];
    sum += state.tension[i];
  }
  double squares = 0;
  for (std::size_t f = 0; f < target.size(); ++f) {
    squares += std::pow(pull[f] / sum - target[f], 2);
  }
  return std::sqrt(squares);
}

// Between neighbours, as quantiles are drawn.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

template <typename Goal>
double over_draws(std::size_t draws, double share, const std::vector<double>& angles, Goal goal) {
  UncertaintyOptions options;
  std::vector<double> goals;
  for (std::size_t d = 0; d < draws; ++d) {
    const Hardware drawn = draw_model(options, d).hardware;
    const double factor = drawn.sheath.angle_rad / Hardware{}.sheath.angle_rad;
    goals.push_back(goal(with_sheaths(drawn, angles, factor)));
  }
  return quantile(goals, share);
}

TEST(RobustGoal, IsTheQuantileOverTheDrawsOfTheUncertainty) {
  SizingOptions options = sizing("uniformity*efficiency", {"sheath_angle=3..9"});
  options.robust = true;
  options.draws = 37;
  const SizingProblem problem(parse_routing("M-1-P-2-M"), options);
  const double expected = over_draws(
      37, 0.05, {4, 7}, [](const Hardware& hardware) { return product("M-1-P-2-M", hardware); });
  EXPECT_NEAR(problem.goal({4, 7}), expected, 1e-9);
  EXPECT_NEAR(problem.nominal_goal({4, 7}), product("M-1-P-2-M", with_sheaths({}, {4, 7})), 1e-12);
  UncertaintyOptions uncertainty;
  std::vector<double> plain;
  for (std::size_t d = 0; d < 37; ++d) {
    plain.push_back(product("M-1-P-2-M", draw_model(uncertainty, d).hardware));
  }
  EXPECT_NEAR(problem.goal(problem.nearest_to_nominal()), quantile(plain, 0.05), 1e-9);
}

TEST(RobustGoal, VariesTheBlocksAsTheBearings) {
  SizingOptions plain = sizing("uniformity_worst", {"sheath_angle=3..9"});
  plain.nominal.hardware.bearing.mu = 0.05;
  plain.robust = true;
  plain.draws = 50;
  SizingOptions own = plain;
  own.nominal.hardware.block = plain.nominal.hardware.bearing;
  const Routing routing = parse_routing("M-Y1+F-1b-Y1-2b-F");
  const SizingPoint at{6};
  EXPECT_EQ(SizingProblem(routing, own).goal(at), SizingProblem(routing, plain).goal(at));
}

TEST(Sizing, IsAtLeastAsGoodAsADenseGrid) {
  SizingOptions options = aiming("1=0.6,2=0.4", {"sheath_angle=2..11"});
  options.robust = true;
  options.draws = 20;
  const SizedDesign found = sized("M-1-P-2-M", options);
  double least = 1;
  constexpr int steps = 36;
  for (int i = 0; i <= steps; ++i) {
    for (int k = 0; k <= steps; ++k) {
      least = std::min(least, over_draws(20, 0.95, {2 + 9.0 * i / steps, 2 + 9.0 * k / steps},
                                         [](const Hardware& hardware) {
                                           return miss("M-1-P-2-M", hardware, {0.6, 0.4});
                                         }));
    }
  }
  const double goal = SizingProblem(parse_routing("M-1-P-2-M"), options).goal(values_of(found));
  EXPECT_LE(goal, least + 1e-9);
  EXPECT_GT(goal, least - 0.01);
  const auto over = [&](std::size_t draws) {
    return over_draws(draws, 0.95, values_of(found), [](const Hardware& hardware) {
      return miss("M-1-P-2-M", hardware, {0.6, 0.4});
    });
  };
  EXPECT_NEAR(goal, over(20), 1e-12);
  // The search uses few draws, and the result uses as many as everywhere.
  EXPECT_NEAR(found.after.goal, over(1000), 1e-12);
}

TEST(Sizing, IsNotImprovedByTenThousandRandomProbes) {
  for (const char* goal : {"uniformity*efficiency", "uniformity_worst", "reliability",
                           "torsional_balance*efficiency_worst"}) {
    SizingOptions options =
        sizing(goal, {"sheath_angle=2..11", "tip_angle=0.5..5", "closing[2]=0.5..2"});
    const SizedDesign found = sized("M-1-P-2-M", options);
    const SizingProblem problem(parse_routing("M-1-P-2-M"), options);
    std::mt19937 random(7);
    double best = -1e9;
    for (int i = 0; i < 10000; ++i) {
      std::vector<double> point;
      for (const Interval& interval : problem.box()) {
        point.push_back(std::uniform_real_distribution(interval.low, interval.high)(random));
      }
      best = std::max(best, problem.nominal_goal(point));
    }
    EXPECT_GE(found.after.goal, best - 1e-9) << goal;
    EXPECT_GE(found.after.goal, found.before.goal - 1e-9) << goal;
  }
}

TEST(Sizing, OfAGoalOfWhichLessIsBetterLessensIt) {
  const SizedDesign design =
      sized("M-Y1+1x-Y1-2x", sizing("travel", {"closing[1]=0.5..2", "closing[2]=0.5..2"}));
  EXPECT_LE(design.after.goal, design.before.goal);
}

TEST(SizingThreads, DoNotChangeTheResult) {
  SizingOptions options =
      sizing("uniformity*efficiency_worst", {"sheath_angle=3..9", "strand_mm=50..90"});
  options.robust = true;
  options.draws = 10;
  const std::vector<Routing> routings{parse_routing("M-1-P-2-M"), parse_routing("1-T-2-P-1")};
  const SizingResult one = size(routings, options);
  for (const int threads : has_sanitizer() ? std::vector{3} : std::vector{2, 3, 8}) {
    options.threads = threads;
    const SizingResult several = size(routings, options);
    for (std::size_t i = 0; i < routings.size(); ++i) {
      EXPECT_EQ(values_of(several.designs[i]), values_of(one.designs[i]));
      EXPECT_EQ(several.designs[i].after.goal, one.designs[i].after.goal);
      EXPECT_EQ(several.designs[i].after.values, one.designs[i].after.values);
    }
  }
}

TEST(Sizing, StoppedGivesTheBestSoFar) {
  const std::atomic<bool> stop{true};
  SizingOptions options = sizing("efficiency", {"sheath_angle[1]=3..9"});
  const SizingResult result = size({parse_routing("M-1-T-2-F")}, options, {{}, &stop});
  EXPECT_TRUE(result.partial);
  const SizedDesign& design = result.designs.at(0);
  EXPECT_EQ(values_of(design).size(), 1U);
  EXPECT_GE(design.after.goal, design.before.goal);
}

TEST(Sizing, TellsHowFarItIs) {
  std::uint64_t last = 0;
  std::uint64_t total = 0;
  SizingOptions options = sizing("efficiency", {"sheath_angle[1]=3..9"});
  size({parse_routing("M-1-T-2-F")}, options,
       {[&](const Progress& progress) {
          EXPECT_EQ(progress.done, last + 1);
          last = progress.done;
          total = progress.total;
        },
        nullptr});
  EXPECT_EQ(last, total);
  EXPECT_EQ(total, static_cast<std::uint64_t>(options.starts) + 2);
}

TEST(Sizing, WithoutAnyDimensionOfItsOwnARoutingStaysAsItIs) {
  const SizedDesign design =
      sized("F-1-P-2-F", sizing("efficiency", {"contact_angle[h1-h2]=1..2"}));
  EXPECT_TRUE(design.variables.empty());
  EXPECT_EQ(design.after.goal, design.before.goal);
}

TEST(Sizing, RefusesBoundsBeyondAnyContact) {
  SizingOptions options = sizing("efficiency", {"sheath_angle[1]=3..60"});
  EXPECT_THROW(sized("M-1-T-2-F", options), InputError);
  options = sizing("efficiency", {"sheath_angle[1]=3..45"});
  options.evaluations = 20;
  options.starts = 1;
  EXPECT_NO_THROW(sized("M-1-T-2-F", options));
  options.robust = true;  // with 0.2 and a fifth more angle
  EXPECT_THROW(sized("M-1-T-2-F", options), InputError);
}

Model with_three_finger_hand() {
  return {
      read_hardware_file(REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml").hardware, {}, {}};
}

// Looked at beyond its bounds an arm ends at 0.01 mm, and those of other joints may end before it.
TEST(Sizing, LooksForToleranceWhereThereIsHardware) {
  SizingOptions options = sizing("stroke", {"arm_mm=5..15"}, 3);
  options.nominal = with_three_finger_hand();
  options.evaluations = 60;
  options.starts = 1;
  const SizedDesign design = sized("M-1b-B-2b-B-3b-M", options);
  ASSERT_TRUE(design.together);
  for (std::size_t i = 0; i < design.variables.size(); ++i) {
    EXPECT_GE(design.variables[i].value - design.together->ways[i].less, 0.01 - 1e-12);
  }
}

TEST(Sizing, LooksForToleranceWhereAWrapIsOne) {
  const SizingOptions options = aiming("1=5,2=1", {"sheath_angle=0..30"});
  const SizedDesign design = sized("M-1-T-2-M", options);
  ASSERT_EQ(design.variables.size(), 2U);
  // All that there is in hardware, to 10 / 0.18 rad.
  EXPECT_GT(design.variables[1].value, 26);
  EXPECT_FALSE(design.variables[1].sensitivity.more);
}

// Of a tendon of which a finger blocks the other one.
TEST(Sizing, OfADesignForWhichNoMotorIsEnoughFindsNothingBetter) {
  SizingOptions options = sizing("motor_force", {"sheath_angle=2..5"}, 3);
  options.nominal = with_three_finger_hand();
  options.evaluations = 60;
  options.starts = 1;
  const SizedDesign design = sized("M-1-M+M-2-M+M-3-M", options);
  EXPECT_FALSE(std::isfinite(design.before.goal));
  EXPECT_FALSE(std::isfinite(design.after.goal));
}

}  // namespace
}  // namespace reeve::testing
