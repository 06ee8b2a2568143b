// One definition of the motor force, against the capstan law.
#include "search/uncertainty/motor_force.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/notation.hpp"
#include "search/enumerate/generator.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/uncertainty/coefficient_box.hpp"
#include "tests/support/example_hand.hpp"

namespace reeve::testing {
namespace {

// One finger of which each newton of pull is one newton at the fingertip. Only the friction of the
// sheath is uncertain.
UncertaintyOptions one_finger() {
  UncertaintyOptions options{
      Model{hand_of({simple_finger(10, 90, 10, 20)})}, {}, single_grasps(1), {}};
  options.nominal.hardware.scatter = {0, 0};
  options.ranges = {.tube_mu = {0.18, 0.18},
                    .sheath_mu = {0.05, 0.2},
                    .bearing_mu_relative = 0,
                    .sheath_angle_relative = 0};
  return options;
}

// M-1b-F without friction at the tip: both strands have T_M e^{-mu theta}.
double force_at(double sheath_mu, const Hardware& hardware) {
  return 20 / (2 * std::exp(-sheath_mu * hardware.sheath.angle_rad));
}

TEST(MotorForce, IsNominalAndInTheQuantileWhatTheCapstanLawSays) {
  UncertaintyOptions options = one_finger();
  options.nominal.hardware.bearing.mu = 0;
  const auto force = motor_force(parse_routing("M-1b-F"), options);
  ASSERT_TRUE(force);
  EXPECT_NEAR(force->nominal_N, force_at(0.18, options.nominal.hardware), 1e-9);
  // It grows with mu, so that its quantile is that at the quantile of mu, here 0.1925 but for what
  // 1000 draws leave open of it: 0.15 √(0.95 · 0.05 / 1000) = 0.001.
  EXPECT_NEAR(force->p95_N, force_at(0.1925, options.nominal.hardware), 0.4);
  EXPECT_EQ(force->draws, motor_draws);
  EXPECT_TRUE(force->is_met_by(force->p95_N));
  EXPECT_FALSE(force->is_met_by(force->p95_N - 1e-6));
}

TEST(MotorForce, DoesNotVaryWithAFrictionThatWasMeasured) {
  UncertaintyOptions options = one_finger();
  options.ranges = {.sheath_angle_relative = 0};
  Hardware& hardware = options.nominal.hardware;
  for (const char* word : {"M-1b-F", "M-1-F"}) {
    for (ContactLaw* law : {&hardware.tube, &hardware.bearing, &hardware.sheath})
      law->known = false;
    const auto drawn = motor_force(parse_routing(word), options);
    EXPECT_GT(drawn->p95_N, drawn->nominal_N) << word;
    for (ContactLaw* law : {&hardware.tube, &hardware.bearing, &hardware.sheath}) law->known = true;
    const auto known = motor_force(parse_routing(word), options);
    EXPECT_EQ(known->p95_N, known->nominal_N) << word;
  }
}

// 20 N along 10 mm · π/2 on each of two fingers; against its spring finger 2 takes 30 N.
TEST(LeastWork, IsPullTimesExcursionOfTheFingersThatClose) {
  constexpr double half_turn = std::numbers::pi / 2;
  Hardware hardware = hand_of({simple_finger(10, 90, 10, 20), simple_finger(10, 90, 10, 20)});
  EXPECT_NEAR(least_work_J(hardware, 2, parse_grasps("none", 2)), 2 * 20 * 10 * half_turn / 1000,
              1e-12);
  EXPECT_NEAR(least_work_J(hardware, 2, parse_grasps("1", 2)), 20 * 10 * half_turn / 1000, 1e-12);
  FingerJoint& joint = hardware.fingers[1].parts.joints.front();
  joint.spring_Nmm_rad = 10 * 30 / half_turn;
  joint.held_deg = 0;
  EXPECT_NEAR(least_work_J(hardware, 2, single_grasps(2)), (20 + 30) * 10 * half_turn / 1000,
              1e-12);
  EXPECT_EQ(least_work_J(Hardware{}, 2, single_grasps(2)), 0);
}

// Whatever the routing: motor force times stroke is no less, and without friction some has no more.
TEST(LeastWork, IsABoundOfAllRoutingsThatCloseTheHand) {
  UncertaintyOptions options{Model{hand_of({simple_finger(10, 90, 60, 10), three_joint_finger(),
                                            simple_finger(6, 70, 30, 3)})},
                             {},
                             single_grasps(3),
                             {}};
  options.draws = 1;
  const EvaluationScope scope =
      scope_for({Objective::motor_force, Objective::stroke, Objective::closure}, options.score);
  const GeneratorOptions parts{all_parts(), 3, FingerIdentity::distinct, false};
  double least_lossless = std::numeric_limits<double>::infinity();
  for (const bool is_lossless : {false, true}) {
    for (ContactLaw* law : {&options.nominal.hardware.tube, &options.nominal.hardware.sheath,
                            &options.nominal.hardware.bearing}) {
      if (is_lossless) law->mu = 0;
    }
    RoutingGenerator generator(parts);
    Routing routing;
    DesignEvaluator evaluator(options.nominal, options.grasps, options.score);
    const double least_J = least_work_J(options.nominal.hardware, 3, options.grasps);
    while (generator.next(routing)) {
      if (!is_actuated(routing)) continue;
      const ObjectiveValues values = evaluator.evaluate(routing, scope);
      if (value(values, Objective::closure) < 1) continue;
      const double asked_J =
          value(values, Objective::motor_force) * value(values, Objective::stroke) / 1000;
      ASSERT_GE(asked_J, least_J * (1 - 1e-6)) << to_word(routing);
      if (is_lossless) least_lossless = std::min(least_lossless, asked_J / least_J);
    }
  }
  EXPECT_LT(least_lossless, 1.2);
}

TEST(MotorForce, IsThatOfTheGraspThatAsksForMost) {
  UncertaintyOptions options = one_finger();
  options.nominal.hardware =
      hand_of({simple_finger(10, 90, 10, 20), simple_finger(10, 90, 10, 20)});
  const Routing routing = parse_routing("M-1-T-2-F");
  options.grasps = parse_grasps("none", 2);
  const double open = motor_force(routing, options)->nominal_N;
  options.grasps = parse_grasps("1", 2);
  const double held = motor_force(routing, options)->nominal_N;
  options.grasps = parse_grasps("none/1", 2);
  EXPECT_EQ(motor_force(routing, options)->nominal_N, std::max(open, held));
}

TEST(MotorForce, IsOfHandsAlone) {
  EXPECT_FALSE(motor_force(parse_routing("M-1-F"), {Model{}, {}, single_grasps(1), {}}));
}

TEST(MotorForce, IsInfiniteInTheQuantileWhereADrawHasMoreFrictionThanContacts) {
  UncertaintyOptions options = one_finger();
  options.ranges.sheath_mu = {0.05, 9};
  options.nominal.hardware.sheath.angle_rad = 40;
  options.nominal.hardware.sheath.mu = 0.01;
  const auto force = motor_force(parse_routing("M-1b-F"), options);
  EXPECT_TRUE(std::isfinite(force->nominal_N));
  EXPECT_TRUE(std::isinf(force->p95_N));
}

// Posture bends whatever was mounted: a bend of its own turns with those of the others.
TEST(DrawnHardware, BendsTheSheathsOfSingleFingersInProportion) {
  Model nominal;
  FingerHardware finger;
  finger.finger = 1;
  finger.sheath_angle_rad = 4.0;
  finger.tip_angle_rad = 2.0;
  nominal.hardware.fingers.push_back(finger);
  nominal.hardware.contacts.push_back({"h1", "b", std::nullopt, 3.0});
  nominal.hardware.contacts.push_back({"T1", "T2", std::nullopt, 1.0});
  for (std::uint64_t draw = 0; draw < 5; ++draw) {
    const Hardware drawn = draw_model(nominal, {}, 1, draw).hardware;
    const double factor = drawn.sheath.angle_rad / Hardware{}.sheath.angle_rad;
    EXPECT_NE(factor, 1);
    EXPECT_NEAR(*drawn.fingers[0].sheath_angle_rad, 4 * factor, 1e-12);
    EXPECT_EQ(*drawn.fingers[0].tip_angle_rad, 2);
    EXPECT_NEAR(*drawn.contacts[0].angle_rad, 3 * factor, 1e-12);
    EXPECT_EQ(*drawn.contacts[1].angle_rad, 1);
  }
}

}  // namespace
}  // namespace reeve::testing
