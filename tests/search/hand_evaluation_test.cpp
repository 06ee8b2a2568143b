#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/hand_closing.hpp"
#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/explore.hpp"
#include "tests/support/example_hand.hpp"

namespace reeve {
namespace {

using testing::hand_of;
using testing::simple_finger;

constexpr double without_end = std::numeric_limits<double>::infinity();

Hardware hand_of_two_fingers() {
  Hardware hardware = hand_of({simple_finger(8, 90, 60, 5), testing::three_joint_finger()});
  hardware.motor.close_s = 0.5;
  return hardware;
}

ObjectiveValues evaluate(const std::string& word, const Hardware& hardware,
                         const GraspSet& grasps = single_grasps(2),
                         const EvaluationScope& scope = {}) {
  return DesignEvaluator(hardware, grasps).evaluate(parse_routing(word), scope);
}

TEST(HandObjectives, AreZeroAndAbsentWithoutAHand) {
  const ObjectiveValues values = evaluate("M-1-T-2-F", Hardware{});
  EXPECT_FALSE(has_hand(values));
  for (const ObjectiveRow& row : objective_table()) {
    EXPECT_EQ(row.of_hand ? value(values, row.objective) : 0, 0) << row.name;
    EXPECT_EQ(is_there(row, values), !row.of_hand) << row.name;
  }
}

TEST(HandObjectives, AreNotThereIfAFingerIsNotKnown) {
  EXPECT_FALSE(has_hand(evaluate("M-1-T-2-F", hand_of({simple_finger(8, 90, 60, 5)}))));
}

TEST(HandObjectives, AreTheMostThatAGraspAsksForAndTheLeastThatAFingerGets) {
  const Hardware hardware = hand_of_two_fingers();
  const Network net = expand(parse_routing("M-1-P-2-F"));
  const Mechanics parts = mechanics(net, hardware);
  double most = 0;
  double least = without_end;
  double mean = 0;
  const GraspSet grasps = parse_grasps("none:3/1:1", 2);
  for (const WeightedGrasp& grasp : grasps) {
    const GripDemand demand = grip_demand(*hand(hardware), net.fingers,
                                          testing::pulls_in(net, parts, grasp.grasp), grasp.grasp);
    most = std::max(most, demand.motor_force_N);
    least = std::min(least, demand.force_per_motor_N);
    mean += grasp.weight * demand.force_per_motor_N / 4;
  }
  const ObjectiveValues values = evaluate("M-1-P-2-F", hardware, grasps);
  EXPECT_NEAR(value(values, Objective::motor_force), most, 1e-9);
  EXPECT_NEAR(value(values, Objective::fingertip_force_worst), least, 1e-9);
  EXPECT_NEAR(value(values, Objective::fingertip_force_mean), mean, 1e-9);
}

// Finger 2 is held: joint 1 feels what one guide leaves of the strand from finger 1, and what five
// guides leave in the strand that comes back.
TEST(HandObjectives, FollowTheTensionsBehindTheGuidesOfAHeldFinger) {
  FingerParts parts{{{10, 80, 60, 0, 0, 55.0}, {8, 80, 40, 0, 0, 55.0}, {6, 80, 20, 0, 0, 55.0}},
                    5.0};
  for (FingerJoint& joint : parts.joints) {
    joint.guide = JointGuide::tube;
    joint.mu = 0.1;
  }
  Hardware hardware = hand_of({parts, parts});
  for (ContactLaw* law : {&hardware.tube, &hardware.bearing, &hardware.sheath}) law->mu = 0;
  const double phi = 0.1 * in_rad(55);
  const double pull = std::exp(-6 * phi) * (std::exp(-phi) + std::exp(-5 * phi));
  const ObjectiveValues values =
      evaluate("M-1b-B-2b-F", hardware, {{hold({2}), 1}}, {false, false, true, false, false});
  EXPECT_NEAR(value(values, Objective::fingertip_force_worst), pull * 10 / 60, 1e-9);
  EXPECT_NEAR(value(values, Objective::motor_force), 60 * 5 / (pull * 10), 1e-6);
}

TEST(HandObjectives, FollowTheStrokeToTheMotorsPower) {
  const ObjectiveValues values = evaluate("M-1-T-2-F", hand_of_two_fingers());
  const Hand known = *hand(hand_of_two_fingers());
  const double stroke = 2 * (known.finger(1).excursion_mm + known.finger(2).excursion_mm);
  EXPECT_NEAR(value(values, Objective::stroke), stroke, 1e-9);
  EXPECT_EQ(value(values, Objective::closure), 1);
  EXPECT_NEAR(value(values, Objective::motor_power),
              value(values, Objective::motor_force) * stroke / 1000 / 0.5, 1e-9);
}

TEST(HandObjectives, AreInfiniteWhereABlockedCarriageLeavesAFingerSlack) {
  const ObjectiveValues values = evaluate("M-1-M+M-2-M", hand_of_two_fingers());
  EXPECT_EQ(value(values, Objective::motor_force), without_end);
  EXPECT_EQ(value(values, Objective::motor_power), without_end);
  EXPECT_LT(value(values, Objective::closure), 1);
  EXPECT_TRUE(has_hand(values));
}

DesignOutcome outcome(const std::string& word, const Hardware& hardware, const GraspSet& grasps) {
  return DesignEvaluator(hardware, grasps).outcome(parse_routing(word));
}

// Without friction both strands have the tendon's tension T, and the fingertip 2 T r / h.
Hardware frictionless(Hardware hardware) {
  for (ContactLaw* law : {&hardware.tube, &hardware.bearing, &hardware.sheath}) law->mu = 0;
  return hardware;
}

// Finger 1 needs 60 / 8 · 5 / 2 N, finger 2 50 / 10 · 6 / 2 N, held or not: a finger that is held
// blocks its own motor only.
TEST(HandOfSeveralMotors, WithATendonEachHasTheForceAndStrokeOfItsOwnFinger) {
  const Hardware hardware =
      frictionless(hand_of({simple_finger(8, 90, 60, 5), simple_finger(10, 70, 50, 6)}));
  const DesignOutcome design = outcome("M-1-F+M2-2-F", hardware, single_grasps(2));
  const Hand known = *hand(hardware);
  EXPECT_NEAR(motor_forces(design)[0], 18.75, 1e-9);
  EXPECT_NEAR(motor_forces(design)[1], 15, 1e-9);
  EXPECT_NEAR(design.hand.strokes_mm[0], 2 * known.finger(1).excursion_mm, 1e-9);
  EXPECT_NEAR(design.hand.strokes_mm[1], 2 * known.finger(2).excursion_mm, 1e-9);
  EXPECT_EQ(design.hand.closure, 1);
  ObjectiveValues values{};
  compute_objectives(design, values);
  EXPECT_NEAR(value(values, Objective::motor_force), 18.75, 1e-9);
  EXPECT_NEAR(value(values, Objective::stroke), 2 * known.finger(1).excursion_mm, 1e-9);
  EXPECT_NEAR(
      value(values, Objective::motor_power),
      (18.75 * 2 * known.finger(1).excursion_mm + 15 * 2 * known.finger(2).excursion_mm) / 1000,
      1e-9);
}

// Each motor pulls one strand of the finger: its force is half the pull behind its sheath.
TEST(HandOfSeveralMotors, OnOneTendonShareItsPullAlike) {
  const Hardware hardware = hand_of({simple_finger(8, 90, 60, 5)});
  const DesignOutcome design = outcome("M-1-M2", hardware, single_grasps(1));
  const double force = 60.0 / 8 * 5 / 2 * std::exp(hardware.sheath.exponent());
  EXPECT_NEAR(motor_forces(design)[0], force, 1e-9);
  EXPECT_NEAR(motor_forces(design)[1], force, 1e-9);
  EXPECT_NEAR(design.hand.strokes_mm[0], hand(hardware)->finger(1).excursion_mm, 1e-9);
}

// Without friction all segments have one tension. The carriages take in 1.5 D = 2 E.
TEST(HandOfSeveralMotors, WhoseCarriagesTravelUnlikeHaveStrokesInThatRatio) {
  const Hardware hardware = frictionless(hand_of({simple_finger(8, 90, 60, 5)}));
  const DesignOutcome design = outcome("M-1-M2", hardware, parse_grasps("none@1,0.5", 1, 2));
  const double excursion = hand(hardware)->finger(1).excursion_mm;
  EXPECT_NEAR(design.hand.strokes_mm[0], 2 * excursion / 1.5, 1e-9);
  EXPECT_NEAR(design.hand.strokes_mm[1], excursion / 1.5, 1e-9);
  EXPECT_NEAR(motor_forces(design)[0], 18.75, 1e-9);
  EXPECT_NEAR(motor_forces(design)[1], 18.75, 1e-9);
}

// Every way in which the carriages travel must fit.
TEST(HandOfSeveralMotors, HaveTheGreatestStrokesOfAllTravelsOfTheirCarriages) {
  const Hardware hardware = hand_of({simple_finger(8, 90, 60, 5)});
  const DesignOutcome design =
      outcome("M-1-M2", hardware, parse_grasps("none@1,0.5/none@0.5,1", 1, 2));
  const double excursion = hand(hardware)->finger(1).excursion_mm;
  EXPECT_NEAR(design.hand.strokes_mm[0], 2 * excursion / 1.5, 1e-9);
  EXPECT_NEAR(design.hand.strokes_mm[1], 2 * excursion / 1.5, 1e-9);
}

// The motors take in 1 − 0.5 of D.
TEST(HandOfSeveralMotors, OfWhichOneLetsOutHaveTheStrokesOfBoth) {
  const Hardware hardware = frictionless(hand_of({simple_finger(8, 90, 60, 5)}));
  const DesignOutcome design = outcome("M-1-M2", hardware, parse_grasps("none@1,-0.5", 1, 2));
  const double excursion = hand(hardware)->finger(1).excursion_mm;
  EXPECT_NEAR(design.hand.strokes_mm[0], 4 * excursion, 1e-9);
  EXPECT_NEAR(design.hand.strokes_mm[1], 2 * excursion, 1e-9);
  EXPECT_NEAR(motor_forces(design)[0], 18.75, 1e-9);
}

double hand_value(const DesignOutcome& design, Objective objective) {
  ObjectiveValues values{};
  compute_objectives(design, values);
  return value(values, objective);
}

bool has_hand_in(const std::string& word, const Hardware& hardware, const std::string& grasps) {
  ObjectiveValues values{};
  compute_objectives(outcome(word, hardware, parse_grasps(grasps, 2, 2)), values);
  return has_hand(values);
}

// While the flexors close the hand the extensors are slack; what opens it again grips nothing. With
// one finger held, the other closes by 2 D.
TEST(HandOfSeveralMotors, WithExtensorsGripsAsWithoutThemWhileTheseAreLetOut) {
  const Hardware hardware = hand_of({simple_finger(8, 90, 60, 5), simple_finger(8, 90, 50, 6)});
  const DesignOutcome flexors = outcome("1x-P-2x", hardware, single_grasps(2));
  const DesignOutcome both =
      outcome("1x-P-2x+M2-1e+M2-2e", hardware,
              parse_grasps("none@1,-1/1@1,-2/2@1,-2/none@-1,1:5/1@-1,1:2", 2, 2));
  for (const Objective objective : {Objective::motor_force, Objective::fingertip_force_mean,
                                    Objective::fingertip_force_worst}) {
    EXPECT_DOUBLE_EQ(hand_value(both, objective), hand_value(flexors, objective));
  }
  EXPECT_EQ(motor_forces(both)[1], 0);
  EXPECT_DOUBLE_EQ(both.hand.strokes_mm[0], flexors.hand.stroke_mm);
  EXPECT_DOUBLE_EQ(both.hand.strokes_mm[1], 2 * flexors.hand.stroke_mm);
  EXPECT_EQ(both.hand.closure, 1);
  EXPECT_FALSE(has_hand_in("1x-P-2x+M2-1e+M2-2e", hardware, "none@-1,1"));
}

TEST(HandOfSeveralMotors, OfWhichOneStandsStillIsPulledByNoForceOfIt) {
  const Hardware hardware = hand_of({simple_finger(8, 90, 60, 5), simple_finger(10, 70, 50, 6)});
  const DesignOutcome design = outcome("M-1-F+M2-2-F", hardware, parse_grasps("none@1,0", 2, 2));
  EXPECT_TRUE(std::isfinite(motor_forces(design)[0]));
  EXPECT_EQ(motor_forces(design)[1], without_end);
  EXPECT_EQ(design.hand.strokes_mm[1], 0);
  EXPECT_EQ(design.hand.closure, 0);
}

TEST(HandObjectives, ThatNobodyAsksForAreLeftOut) {
  const std::vector<Objective> plain{Objective::uniformity_mean};
  EXPECT_FALSE(scope_for(plain, authors_score()).hand);
  EXPECT_TRUE(scope_for({Objective::closure}, authors_score()).hand);
  EXPECT_TRUE(scope_for({Objective::score}, parse_score("stroke=0.1")).hand);
  const ObjectiveValues full = evaluate("M-1-T-2-F", hand_of_two_fingers());
  const ObjectiveValues left_out =
      evaluate("M-1-T-2-F", hand_of_two_fingers(), single_grasps(2), {true, true, false});
  for (const ObjectiveRow& row : objective_table()) {
    EXPECT_EQ(value(left_out, row.objective), row.of_hand ? 0 : value(full, row.objective));
  }
}

ExploreOptions hand_exploration(std::vector<Objective> objectives) {
  ExploreOptions options;
  options.generator = {full_parts(), 2, FingerIdentity::identical, false};
  options.model.hardware.finger_parts = testing::three_joint_finger();
  options.grasps = single_grasps(2);
  options.order = Order(std::move(objectives));
  return options;
}

TEST(HandObjectives, AreThereForEveryDesignOfAnExplorationThatDoesNotAskForThem) {
  const ExploreResult result = explore(hand_exploration({Objective::uniformity_mean}));
  ASSERT_FALSE(result.top.empty());
  for (const RankedDesign& ranked : result.top) EXPECT_TRUE(has_hand(ranked.design.values));
  for (const Design& design : result.sample) EXPECT_TRUE(has_hand(design.values));
}

TEST(HandObjectives, ConstrainAnExploration) {
  ExploreOptions options = hand_exploration({Objective::motor_force, Objective::stroke});
  options.constraints = {parse_constraint("stroke<=80"), parse_constraint("closure>=1")};
  options.threads = 1;
  const ExploreResult result = explore(options);
  ASSERT_FALSE(result.top.empty());
  EXPECT_GT(result.rejected[1].count, 0U);
  for (const RankedDesign& ranked : result.top) {
    EXPECT_LE(value(ranked.design.values, Objective::stroke), 80);
    EXPECT_EQ(value(ranked.design.values, Objective::closure), 1);
  }
  options.threads = 3;
  const ExploreResult again = explore(options);
  ASSERT_EQ(again.top.size(), result.top.size());
  for (std::size_t i = 0; i < result.top.size(); ++i) {
    EXPECT_EQ(again.top[i].design.word, result.top[i].design.word);
    EXPECT_EQ(again.top[i].design.values, result.top[i].design.values);
  }
}

}  // namespace
}  // namespace reeve
