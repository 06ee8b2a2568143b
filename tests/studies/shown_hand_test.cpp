#include "studies/shown_hand.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "tests/support/example_hand.hpp"

namespace reeve {
namespace {

using testing::hand_of;
using testing::simple_finger;

constexpr double degree = std::numbers::pi / 180;

ShownHand shown(const std::string& word, const Hardware& hardware,
                const GraspSet& grasps = single_grasps(2)) {
  return *studies::shown_hand(expand(parse_routing(word)), word, Model{hardware}, grasps);
}

FingerParts sprung(double arm_mm, double range_deg, double spring_Nmm_rad, double force_N) {
  FingerParts parts = simple_finger(arm_mm, range_deg, 60, force_N);
  parts.joints[0].spring_Nmm_rad = spring_Nmm_rad;
  parts.joints[0].rest_deg = -25;
  return parts;
}

// Work of the fingertips of fingers of one joint, posture by posture.
double fingertip_work(const Hardware& hardware, const std::vector<double>& pulls_N) {
  double work_Nmm = 0;
  constexpr int steps = 2000;
  for (std::size_t f = 0; f < pulls_N.size(); ++f) {
    FingerJoint joint = hardware.fingers[f].parts.joints[0];
    const double step = joint.range_deg / steps;
    for (int i = 0; i < steps; ++i) {
      joint.held_deg = step * (i + 0.5);
      const HandFinger finger = hand(hand_of({{{joint}, 1.0}}))->finger(1);
      work_Nmm += held_force(finger, {1}, pulls_N[f]).force_N * joint.lever_mm * step * degree;
    }
  }
  return work_Nmm / 1000;
}

TEST(ShownHand, PartsTheMotorsWorkIntoSpringsFrictionAndFingertips) {
  Hardware hardware = hand_of({sprung(8, 90, 30, 5), sprung(10, 70, 20, 6)});
  for (const char* word : {"M-1-T-2-F", "1-P-2-P-1", "M-1-P-2-M", "M-Y1+1x-Y1-2x"}) {
    const ShownHand found = shown(word, hardware);
    const MotorDemand& demand = found.demand;
    std::vector<double> pulls;
    for (const ShownFingerForce& force : found.grasps[0].fingers) {
      pulls.push_back(force.pull_per_motor.sum_N() * demand.force_N);
    }
    EXPECT_NEAR(demand.work_J, demand.force_N * demand.stroke_mm / 1000, 1e-12);
    EXPECT_NEAR(demand.fingers_J, fingertip_work(hardware, pulls), 1e-6) << word;
    EXPECT_NEAR(demand.work_J, demand.springs_J + demand.friction_J + demand.fingers_J, 1e-9);
    EXPECT_GT(demand.springs_J, 0);
    EXPECT_GT(demand.friction_J, 0);
  }
}

TEST(ShownHand, SaysWhatFrictionCostsByTheSameHandWithoutIt) {
  Hardware hardware = hand_of({simple_finger(8, 90, 60, 5), simple_finger(8, 90, 60, 5)});
  const double with_friction = shown("M-1-T-2-F", hardware).demand.force_N;
  EXPECT_NEAR(shown("M-1-T-2-F", hardware).demand.frictionless_N, 60 * 5 / 8.0 / 2, 1e-9);
  EXPECT_NEAR(shown("M-1-T-2-F", hardware).demand.friction_cost(),
              1 - 60 * 5 / 8.0 / 2 / with_friction, 1e-12);
  for (ContactLaw* law : {&hardware.tube, &hardware.bearing, &hardware.sheath}) law->mu = 0;
  const MotorDemand ideal = shown("M-1-T-2-F", hardware).demand;
  EXPECT_NEAR(ideal.friction_cost(), 0, 1e-12);
  EXPECT_NEAR(ideal.friction_J, 0, 1e-12);
}

TEST(ShownHand, TurnsForceAndSpeedIntoThoseOfTheSpool) {
  Hardware hardware = hand_of({simple_finger(8, 90, 60, 5), simple_finger(8, 90, 60, 5)});
  EXPECT_FALSE(shown("1-P-2-P-1", hardware).demand.torque_Nm);
  hardware.motor = {6.0, 0.5, 20.0, {}};
  const MotorDemand demand = shown("1-P-2-P-1", hardware).demand;
  EXPECT_NEAR(demand.speed_mm_s, demand.stroke_mm / 0.5, 1e-12);
  EXPECT_NEAR(*demand.torque_Nm, demand.force_N * 0.006, 1e-12);
  EXPECT_NEAR(*demand.spool_rpm * 2 * std::numbers::pi / 60 * 6, demand.speed_mm_s, 1e-9);
  // Power is torque times angular speed.
  EXPECT_NEAR(demand.power_W, *demand.torque_Nm * *demand.spool_rpm * 2 * std::numbers::pi / 60,
              1e-9);
}

TEST(ShownHand, NamesFingerJointAndGraspThatAskForMost) {
  const Hardware hardware = hand_of({testing::three_joint_finger(), simple_finger(8, 90, 60, 1)});
  const ShownHand found = shown("M-1-T-2-F", hardware);
  EXPECT_EQ(found.demand.weakest, 1);
  EXPECT_EQ(found.demand.joint, 0U);
  double most = 0;
  for (const ShownHandGrasp& grasp : found.grasps) most = std::max(most, grasp.motor_force_N);
  EXPECT_NEAR(found.demand.force_N, most, 1e-9);
  for (const ShownHandGrasp& grasp : found.grasps) {
    if (grasp.grasp == found.demand.grasp) {
      EXPECT_EQ(grasp.motor_force_N, most);
    }
    for (const ShownFingerForce& force : grasp.fingers) {
      EXPECT_GE(force.force_N,
                found.fingers[static_cast<std::size_t>(force.finger) - 1].wanted_N - 1e-9);
    }
  }
}

TEST(ShownHand, SaysWhatTheMotorsLimitGivesEachFingertip) {
  Hardware hardware = hand_of({simple_finger(8, 90, 60, 5), simple_finger(10, 90, 50, 5)});
  hardware.motor.force_N = 20;
  for (const ShownHandGrasp& grasp : shown("M-1-T-2-F", hardware).grasps) {
    for (const ShownFingerForce& force : grasp.fingers) {
      EXPECT_NEAR(*force.at_limit_N, 20 * force.per_motor_N, 1e-12);
    }
  }
}

TEST(ShownHand, GivesNoForcesWhereNoMotorForceIsEnough) {
  const Hardware hardware = hand_of({simple_finger(8, 90, 60, 5), simple_finger(8, 45, 60, 5)});
  const ShownHand found = shown("M-1-M+M-2-M", hardware);
  EXPECT_TRUE(std::isinf(found.demand.force_N));
  EXPECT_EQ(found.grasps[0].fingers[0].force_N, 0);
  EXPECT_EQ(found.fingers[0].closed, 0.5);
  EXPECT_EQ(found.fingers[1].closed, 1);
}

TEST(ShownHand, LeavesOutGraspsThatOpenFingers) {
  const Hardware hardware = hand_of({sprung(8, 90, 30, 5)});
  const Network network = expand(parse_routing("M-1x+M2-1e"));
  const auto in_grasps = [&](const std::string& grasps) {
    return shown_hand(network, "", Model{hardware}, parse_grasps(grasps, 1, 2));
  };
  const ShownHand both = *in_grasps("none@1,-1/none@-1,1");
  EXPECT_EQ(both.grasps.size(), 1U);
  EXPECT_EQ(to_text(both.opening), "none@-1,1");
  EXPECT_EQ(both.demand.force_N, in_grasps("none@1,-1")->demand.force_N);
  EXPECT_FALSE(in_grasps("none@-1,1"));
}

TEST(ShownHand, IsNothingWithoutAHandOrWithoutFingers) {
  const Network net = expand(parse_routing("M-1-T-2-F"));
  EXPECT_FALSE(studies::shown_hand(net, "M-1-T-2-F", Model{}, single_grasps(2)));
  EXPECT_FALSE(studies::shown_hand(net, "M-1-T-2-F", Model{hand_of({simple_finger(8, 90, 60, 5)})},
                                   single_grasps(2)));
  EXPECT_FALSE(studies::shown_hand(expand(parse_routing("M-F")), "M-F",
                                   Model{hand_of({simple_finger(8, 90, 60, 5)})}, {{Grasp{}, 1}}));
}

}  // namespace
}  // namespace reeve
