#include "core/hand.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/hand_closing.hpp"
#include "tests/core/network_of.hpp"
#include "tests/support/example_hand.hpp"

namespace reeve {
namespace {

using testing::hand_of;
using testing::network_of;
using testing::simple_finger;
using testing::three_joint_finger;

constexpr double degree = std::numbers::pi / 180;

HandFinger finger_of(const FingerParts& parts) { return hand(hand_of({parts}))->finger(1); }

GripDemand demand_of(const std::string& word, const Hardware& hardware, Grasp grasp) {
  const Network net = network_of(word);
  const Mechanics parts = mechanics(net, hardware);
  return grip_demand(*hand(hardware), net.fingers, testing::pulls_in(net, parts, grasp), grasp);
}

// Torque that is left to a joint's flexion under a pull and a fingertip force.
double spare_torque(const FingerJoint& joint, double pull_N, double force_N) {
  const double flexion = joint.held_deg ? *joint.held_deg : joint.range_deg;
  const double spring = joint.spring_Nmm_rad * (flexion - joint.rest_deg) * degree;
  return joint.arm_mm * pull_N - spring - joint.lever_mm * force_N;
}

bool holds(const FingerParts& parts, double pull_N, double force_N) {
  for (const FingerJoint& joint : parts.joints) {
    if (spare_torque(joint, pull_N, force_N) < 0) return false;
  }
  return true;
}

TEST(Hand, IsThereOnlyIfAFingerHasJoints) {
  EXPECT_FALSE(hand(Hardware{}));
  EXPECT_FALSE(hand(hand_of({FingerParts{}})));
  EXPECT_TRUE(hand(hand_of({FingerParts{}, simple_finger(8, 90, 60, 5)})));
}

TEST(Hand, TakesFromTheCommonPartsWhatAFingerHasNotOfItsOwn) {
  Hardware hardware = hand_of({FingerParts{{}, 12.0}, simple_finger(9, 60, 50, 3)});
  hardware.finger_parts = simple_finger(8, 90, 60, 5);
  const Hand found = *hand(hardware);
  EXPECT_EQ(found.finger(1).force_N, 12);
  EXPECT_EQ(found.finger(1).joints, hardware.finger_parts.joints);
  EXPECT_EQ(found.finger(2).force_N, 3);
  EXPECT_EQ(found.finger(2).joints, hardware.fingers[1].parts.joints);
  EXPECT_EQ(found.finger(3).force_N, 5);
  EXPECT_EQ(first_unknown_finger(found, max_fingers), 0);
}

TEST(Hand, DoesNotKnowFingersThatLackJointsOrAForce) {
  FingerParts no_force = simple_finger(8, 90, 60, 5);
  no_force.force_N.reset();
  const Hand found = *hand(hand_of({simple_finger(8, 90, 60, 5), no_force, FingerParts{{}, 5.0}}));
  EXPECT_EQ(first_unknown_finger(found, 1), 0);
  EXPECT_EQ(first_unknown_finger(found, 2), 2);
  EXPECT_FALSE(found.finger(3).is_known);
}

TEST(HandFinger, WithOneJointFollowsTheLeverLaw) {
  const HandFinger finger = finger_of({{{8, 90, 60, 20, -30, 45.0}}, 5.0});
  const double spring = 20 * 75 * degree;
  EXPECT_DOUBLE_EQ(held_force(finger, {1}, 70).force_N, (8 * 70 - spring) / 60);
  EXPECT_DOUBLE_EQ(motor_force(finger, true, {1}), (60 * 5 + spring) / 8);
  EXPECT_DOUBLE_EQ(finger.demands[0].close_N, 20 * 120 * degree / 8);
  EXPECT_DOUBLE_EQ(finger.excursion_mm, 8 * std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(force_without_springs(finger, {1}), 8.0 / 60);
}

// Bisection over the fingertip force, with no formula for it.
TEST(HandFinger, HoldsTheGreatestForceThatNoJointGivesWayTo) {
  const FingerParts parts = three_joint_finger();
  const HandFinger finger = finger_of(parts);
  for (const double pull : {5.0, 20.0, 60.0, 200.0}) {
    double low = 0;
    double high = 1000;
    for (int i = 0; i < 100; ++i) {
      const double force = (low + high) / 2;
      (holds(parts, pull, force) ? low : high) = force;
    }
    const HeldForce held = held_force(finger, {1}, pull);
    EXPECT_NEAR(held.force_N, low, 1e-9) << pull;
    if (low > 0) {
      EXPECT_NEAR(spare_torque(parts.joints[held.joint], pull, held.force_N), 0, 1e-9);
    }
  }
}

TEST(HandFinger, HoldsNothingWhileThePullDoesNotOvercomeItsSprings) {
  EXPECT_EQ(held_force(finger_of(three_joint_finger()), {1}, 0.5).force_N, 0);
}

TEST(HandFinger, NeedsForAForceThePullThatHoldsIt) {
  const FingerParts parts = three_joint_finger();
  const HandFinger finger = finger_of(parts);
  const HeldForce held = held_force(finger, {1}, motor_force(finger, true, {1}));
  EXPECT_DOUBLE_EQ(held.force_N, 5);
  EXPECT_EQ(held.joint, asked_force(finger, true, {1}).joint);
  EXPECT_EQ(held.joint, 0U);  // the knuckle has the longest lever for its arm
}

TEST(HandFinger, AsksThroughTheJointWhoseGripOrClosingNeedsMost) {
  FingerParts parts = three_joint_finger();
  parts.joints = {{.arm_mm = 10, .range_deg = 90, .lever_mm = 10},
                  {.arm_mm = 10, .range_deg = 90, .lever_mm = 60}};
  parts.joints[0].spring_Nmm_rad = 100;
  parts.joints[0].held_deg = 10;
  parts.force_N = 1;
  const HandFinger finger = finger_of(parts);
  EXPECT_EQ(asked_force(finger, true, {1}).joint, 1U);
  const AskedForce open = asked_force(finger, false, {1});
  EXPECT_EQ(open.joint, 0U);
  EXPECT_DOUBLE_EQ(open.motor_N, 100 * 90 * degree / 10);
}

TEST(HandFinger, KeepsInItsSpringsTheWorkOfTurningItsJoints) {
  const FingerParts parts = three_joint_finger();
  for (const double share : {0.3, 1.0}) {
    double work_Nmm = 0;
    constexpr int steps = 1000;
    for (const FingerJoint& joint : parts.joints) {
      const double step = share * joint.range_deg / steps;
      for (int i = 0; i < steps; ++i) {
        const double flexion = step * (i + 0.5);  // the torque is linear: midpoints are exact
        work_Nmm += joint.spring_Nmm_rad * (flexion - joint.rest_deg) * degree * step * degree;
      }
    }
    EXPECT_NEAR(spring_energy(finger_of(parts), share), work_Nmm / 1000, 1e-12);
  }
}

// TR1: the tendon slides from fixed end to motor, so that each contact on the way takes e^{-phi}.
TEST(GripDemand, OfOneOpenTendonIsTheProductOfItsContacts) {
  const Hardware hardware = hand_of({simple_finger(8, 90, 60, 5), simple_finger(10, 70, 50, 6)});
  const double sheath = std::exp(-hardware.sheath.exponent());
  const double tube = std::exp(-hardware.tube.exponent());
  const double first = sheath * (1 + tube);
  const double second = sheath * (tube * tube + tube * tube * tube);
  const GripDemand demand = demand_of("M-1-T-2-F", hardware, {});
  EXPECT_EQ(demand.weakest, 2);
  EXPECT_NEAR(demand.motor_force_N, (50.0 / 10 * 6) / second, 1e-9);
  EXPECT_NEAR(demand.force_per_motor_N, std::min(first * 8 / 60, second * 10 / 50), 1e-12);
}

TEST(GripDemand, AsksOnlyFingersThatAreNotHeldToCloseAgainstTheirSprings) {
  FingerParts stiff = simple_finger(8, 90, 60, 1);
  stiff.joints[0].spring_Nmm_rad = 1000;
  stiff.joints[0].held_deg = 10;
  const Hardware hardware = hand_of({stiff});
  const HandFinger finger = hand(hardware)->finger(1);
  ASSERT_GT(finger.demands[0].close_N, motor_force(finger, true, {1}));
  EXPECT_DOUBLE_EQ(motor_force(finger, true, {0.5}), motor_force(finger, true, {1}) / 0.5);
  EXPECT_DOUBLE_EQ(motor_force(finger, false, {0.5}), finger.demands[0].close_N / 0.5);
}

TEST(GripDemand, IsOfThePostureAtTheObjectUnlessAnotherIsGiven) {
  FingerParts range = simple_finger(8, 90, 60, 5);
  range.joints[0].spring_Nmm_rad = 12;
  FingerParts object = range;
  object.joints[0].object_deg = 30;
  FingerParts given = range;
  given.joints[0].held_deg = 30;
  const auto force = [](const FingerParts& parts) {
    return motor_force(finger_of(parts), true, {1});
  };
  EXPECT_EQ(force(object), force(given));
  EXPECT_LT(force(object), force(range));
}

TEST(GripDemand, IsInfiniteWhereABlockedCarriageLeavesAFingerSlack) {
  const Hardware hardware = hand_of({simple_finger(8, 90, 60, 5), simple_finger(10, 70, 50, 6)});
  const GripDemand demand = demand_of("M-1-M+M-2-M", hardware, hold({1}));
  EXPECT_EQ(demand.motor_force_N, std::numeric_limits<double>::infinity());
  EXPECT_EQ(demand.weakest, 2);
  EXPECT_EQ(demand.force_per_motor_N, 0);
}

TEST(GripDemand, OfAHandThatWantsNothingAndHasNoSpringsIsNothing) {
  const Hardware hardware = hand_of({simple_finger(8, 90, 60, 0), simple_finger(8, 90, 60, 0)});
  EXPECT_EQ(demand_of("M-1-M+M-2-M", hardware, hold({1})).motor_force_N, 0);
}

TEST(MechanicsOfAHand, CloseFingersByTheirExcursions) {
  const Hardware hardware = hand_of({simple_finger(8, 90, 60, 5), simple_finger(10, 36, 50, 6)});
  const Network net = network_of("M-1-T-2-F");
  const Mechanics parts = mechanics(net, hardware);
  EXPECT_DOUBLE_EQ(parts.closing[0], 1);
  EXPECT_DOUBLE_EQ(parts.closing[1], 0.5);  // 10 · 36 of 8 · 90
  const TensionState state = tensions(net, parts, {});
  EXPECT_DOUBLE_EQ(state.closing[0], 2 * state.closing[1]);
  EXPECT_DOUBLE_EQ(2 * (state.closing[0] + state.closing[1]), 1);
}

TEST(MechanicsOfAHand, KeepTheClosingSharesOfFingersThatAreNotAllKnown) {
  Hardware hardware = hand_of({simple_finger(8, 90, 60, 5), FingerParts{}});
  hardware.fingers[1].closing = 0.3;
  const Mechanics parts = mechanics(network_of("M-1-T-2-F"), hardware);
  EXPECT_EQ(parts.closing, (std::vector<double>{1, 0.3}));
}

}  // namespace
}  // namespace reeve
