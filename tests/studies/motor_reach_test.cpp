// What a given motor does with a hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "catalog/hardware_file.hpp"
#include "core/notation.hpp"
#include "studies/shown_hand.hpp"
#include "tests/support/example_hand.hpp"

namespace reeve {
namespace {

using testing::hand_of;
using testing::simple_finger;
using testing::three_joint_finger;

ShownHand reach_of(const std::string& word, const Hardware& hardware) {
  return *studies::shown_hand(expand(parse_routing(word)), word, Model{hardware}, single_grasps(2));
}

Hardware with_motor(Hardware hardware, double force_N, double stroke_mm) {
  hardware.motor.force_N = force_N;
  hardware.motor.stroke_mm = stroke_mm;
  return hardware;
}

// Without springs forces are linear, so the share of the wanted forces is that of the motor's.
TEST(ForceReach, WithoutSpringsIsTheForceOverTheDemand) {
  const Hardware hardware =
      with_motor(hand_of({simple_finger(8, 90, 60, 5), simple_finger(10, 70, 50, 6)}), 20, 60);
  for (const char* word : {"M-1-T-2-F", "1-P-2-P-1", "M-1-P-2-M"}) {
    const ShownHand hand = reach_of(word, hardware);
    EXPECT_NEAR(hand.force_reach->share, 20 / hand.demand.force_N, 1e-12) << word;
    EXPECT_EQ(hand.force_reach->weakest, hand.demand.weakest) << word;
    EXPECT_EQ(hand.force_reach->grasp, hand.demand.grasp) << word;
  }
}

// With springs: a hand that wants the share of it asks for just that motor force.
TEST(ForceReach, IsWhatAHandMayWantOfThatMotor) {
  Hardware hardware = with_motor(hand_of({three_joint_finger(), three_joint_finger()}), 90, 60);
  hardware.fingers[0].parts.force_N = 9.0;
  const ShownHand hand = reach_of("M-1-P-2-M", hardware);
  ASSERT_GT(hand.force_reach->share, 0);
  ASSERT_LT(hand.force_reach->share, 1);
  for (FingerHardware& finger : hardware.fingers) {
    finger.parts.force_N = *finger.parts.force_N * hand.force_reach->share;
  }
  EXPECT_NEAR(reach_of("M-1-P-2-M", hardware).demand.force_N, 90, 1e-9);
  EXPECT_NEAR(hand.force_reach->force_N,
              (hand.force_reach->weakest == 1 ? 9 : 5) * hand.force_reach->share, 1e-12);
}

TEST(ForceReach, IsNothingWhereAFingerCannotCloseAgainstItsSprings) {
  const Hardware hardware =
      with_motor(hand_of({three_joint_finger(), three_joint_finger()}), 0.5, 60);
  const ShownHand hand = reach_of("M-1-P-2-M", hardware);
  EXPECT_EQ(hand.force_reach->share, 0);
  EXPECT_GT(hand.force_reach->weakest, 0);
}

// It holds half closed, where its spring asks for little, and cannot close whole.
TEST(ForceReach, CountsThatAFingerThatIsNotHeldMustClose) {
  FingerParts stiff = simple_finger(10, 90, 50, 1);
  stiff.joints[0].spring_Nmm_rad = 100;
  stiff.joints[0].held_deg = 0;
  Hardware hardware = with_motor(hand_of({simple_finger(10, 90, 50, 1), stiff}), 20, 60);
  const ShownHand hand = reach_of("M-1-P-2-M", hardware);
  EXPECT_EQ(hand.force_reach->share, 0);
  EXPECT_EQ(hand.force_reach->weakest, 2);
  EXPECT_FALSE(hand.force_reach->grasp.holds(2));
  hardware.motor.force_N = 2000;
  EXPECT_GT(reach_of("M-1-P-2-M", hardware).force_reach->share, 1);
}

// None of the fingers can close: the one that would need the strongest motor is named.
TEST(ForceReach, OfEqualsNamesTheFingerThatAsksForMost) {
  for (const double stiffer : {30.0, 300.0}) {
    FingerParts fingers[] = {simple_finger(10, 90, 50, 1), simple_finger(10, 90, 50, 1)};
    fingers[0].joints[0].spring_Nmm_rad = 100;
    fingers[1].joints[0].spring_Nmm_rad = stiffer;
    const Hardware hardware = with_motor(hand_of({fingers[0], fingers[1]}), 0.1, 60);
    const ShownHand hand = reach_of("M-1-P-2-M", hardware);
    EXPECT_EQ(hand.force_reach->share, 0);
    EXPECT_EQ(hand.force_reach->weakest, stiffer > 100 ? 2 : 1);
    EXPECT_EQ(hand.force_reach->weakest, hand.demand.weakest);
    EXPECT_NEAR(hand.force_reach->asks_motor_N, hand.demand.force_N, 1e-9);
  }
}

TEST(ForceReach, HasNoWeakestFingerWhereNoneWantsAForce) {
  const Hardware hardware =
      with_motor(hand_of({simple_finger(8, 90, 60, 0), simple_finger(8, 90, 60, 0)}), 20, 60);
  EXPECT_EQ(reach_of("M-1-T-2-F", hardware).force_reach->weakest, 0);
  EXPECT_TRUE(std::isinf(reach_of("M-1-T-2-F", hardware).force_reach->share));
}

// One tendon: all fingers close in proportion, so half of the stroke is half of every range.
TEST(StrokeReach, OfOneTendonIsInProportion) {
  Hardware hardware = hand_of({simple_finger(8, 90, 60, 5), simple_finger(10, 70, 50, 6)});
  const double whole = reach_of("M-1-T-2-F", hardware).demand.stroke_mm;
  for (const double part : {0.25, 0.5, 0.99}) {
    const ShownHand hand = reach_of("M-1-T-2-F", with_motor(hardware, 20, part * whole));
    EXPECT_NEAR(hand.stroke_reach->closure, part, 1e-12);
    EXPECT_NEAR(hand.stroke_reach->stroke_mm, part * whole, 1e-9);
    for (const double closed : hand.stroke_reach->closed) EXPECT_NEAR(closed, part, 1e-12);
  }
  const ShownHand all = reach_of("M-1-T-2-F", with_motor(hardware, 20, 2 * whole));
  EXPECT_EQ(all.stroke_reach->closure, 1);
  EXPECT_NEAR(all.stroke_reach->stroke_mm, whole, 1e-9);
}

// Of fingers 1 to 4 over one block and of finger 5, which goes on when that stands still.
TEST(StrokeReach, IsOneOfAllItsStretches) {
  std::vector<FingerParts> fingers(4, simple_finger(8, 90, 60, 5));
  fingers[0] = simple_finger(4, 90, 60, 5);
  fingers.push_back(simple_finger(80, 90, 60, 5));
  const std::string word = "M-5-Y1+1x-Y1-2x+3x-Y1-4x";
  const double whole = reach_of(word, hand_of(fingers)).demand.stroke_mm;
  for (const double part : {0.3, 0.9}) {
    const ShownHand hand = reach_of(word, with_motor(hand_of(fingers), 20, part * whole));
    EXPECT_NEAR(hand.stroke_reach->stroke_mm, part * whole, 1e-9);
  }
}

// But for rounding: none of them closes least.
TEST(StrokeReach, NamesAllThatCloseAlike) {
  const std::string file = std::string(REEVE_CATALOG_DIR) + "/hardware/three_finger_hand.toml";
  const std::string word = "M-1-T-2-T-3-F";
  const ShownHand hand =
      *studies::shown_hand(expand(parse_routing(word)), word,
                           Model{catalog::read_hardware_file(file).hardware}, single_grasps(3));
  EXPECT_LT(hand.stroke_reach->closure, 0.6);
  EXPECT_EQ(hand.stroke_reach->last, (std::vector<int>{1, 2, 3}));
}

// Two tendons on one carriage: the one with less to give blocks it.
TEST(StrokeReach, NamesTheFingerThatClosesLeast) {
  const Hardware hardware =
      with_motor(hand_of({simple_finger(8, 90, 60, 5), simple_finger(16, 90, 60, 5)}), 20, 10);
  const ShownHand hand = reach_of("M-1-F+M-2-F", hardware);
  const double excursion = 8 * std::acos(-1) / 2;  // of finger 1; finger 2 has twice
  EXPECT_NEAR(hand.stroke_reach->closed[0], 10 / (2 * excursion), 1e-12);
  EXPECT_NEAR(hand.stroke_reach->closed[1], 10 / (4 * excursion), 1e-12);
  EXPECT_EQ(hand.stroke_reach->last, std::vector<int>{2});
}

// Motor, stroke and work are those of the same tendon fixed at its second end.
TEST(HandDemand, WithALockedEndIsThatOfATendonThatIsFixedThere) {
  const Hardware hardware =
      with_motor(hand_of({simple_finger(10, 57.3, 50, 2), simple_finger(10, 57.3, 50, 2)}), 20, 12);
  const auto shown = [&](const std::string& word, const Grasp& grasp) {
    GraspSet grasps{{grasp, 1}};
    if (grasp.locked != 0) grasps.push_back({{}, 1});  // whose stroke is the shorter one
    return *studies::shown_hand(expand(parse_routing(word)), word, Model{hardware}, grasps);
  };
  const ShownHand locked = shown("M-1-T-2-M", {0, {}, 2});
  const ShownHand fixed = shown("M-1-T-2-F", {});
  EXPECT_NEAR(locked.demand.force_N, fixed.demand.force_N, 1e-9);
  EXPECT_NEAR(locked.demand.stroke_mm, fixed.demand.stroke_mm, 1e-9);
  EXPECT_NEAR(locked.demand.work_J, fixed.demand.work_J, 1e-9);
  EXPECT_NEAR(locked.demand.friction_J, fixed.demand.friction_J, 1e-9);
  EXPECT_NEAR(locked.stroke_reach->closure, fixed.stroke_reach->closure, 1e-9);
}

}  // namespace
}  // namespace reeve
