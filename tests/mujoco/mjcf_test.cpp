#include "reports/mujoco/mjcf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>

#include "core/hand_closing.hpp"
#include "core/motor_sides.hpp"
#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "tests/mujoco/simulated_rig.hpp"
#include "tests/studies/shipped_catalogue.hpp"
#include "tests/support/example_hand.hpp"
#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

using testing::hand_of;
using testing::routing_of;
using testing::simple_finger;
using testing::SimulatedRig;
using testing::three_joint_finger;

constexpr double pull_N = 10;

Hardware without_friction(Hardware hardware) {
  for (ContactLaw* law : {&hardware.tube, &hardware.bearing, &hardware.sheath}) law->mu = 0;
  return hardware;
}

void expect_the_same_tensions(const Routing& routing, const Hardware& hardware, Grasp grasp) {
  SimulatedRig rig(mjcf(routing, hardware));
  for (const int finger : held_fingers(grasp)) rig.activate("hold_" + std::to_string(finger));
  rig.pull(pull_N);
  EXPECT_EQ(rig.warnings(), 0);
  EXPECT_LT(rig.greatest_speed(), 1e-3);
  const Network network = expand(routing);
  const TensionState state =
      tensions(network, mechanics(network, without_friction(hardware)), grasp);
  const auto simulated = rig.tensions();
  // Each motor pulls; tensions are for 1 N of all.
  const double pulls_N = pull_N * carriage_count(network);
  EXPECT_EQ(simulated.size(), network.segments.size());
  for (std::size_t k = 0; k < network.segments.size(); ++k) {
    const std::string name = segment_name(network.segments[k]);
    ASSERT_TRUE(simulated.contains(name)) << name;
    EXPECT_NEAR(simulated.at(name) / pulls_N, state.tension[k], 1e-3 * state.tension[k]) << name;
  }
}

TEST(Mjcf, HasAnActuatorForEachMotor) {
  SimulatedRig rig(mjcf(parse_routing("1x-M+2x-M2"), {}));
  rig.pull(pull_N);
  EXPECT_EQ(rig.warnings(), 0);
  for (const auto& [segment, tension] : rig.tensions()) {
    EXPECT_NEAR(tension, pull_N, 1e-2) << segment;
  }
}

TEST(Mjcf, AtRestTheTensionsAreThoseWithoutFriction) {
  for (const char* word : {"TR1", "TR2", "TR3", "TR4", "TR5", "TR6", "TR7", "M-Y1+1x-Y1-2x",
                           "M-Y1+F-1-Y1-2-F", "M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x",
                           "M-B-Y1-B-Y1k+Y1-1x", "M-1-Y1+2-Y1-3-T-2", "M-W1+1x-W1/2:1-2x"}) {
    SCOPED_TRACE(word);
    for (const Grasp& grasp : {Grasp{}, hold({1})}) {
      SCOPED_TRACE(to_text(grasp));
      expect_the_same_tensions(routing_of(word), {}, grasp);
    }
  }
}

TEST(Mjcf, EndsOnSpoolsPullTheirMotorByTheirRatios) {
  for (const double ratio : {0.5, 2.0, -0.5}) {
    SCOPED_TRACE(ratio);
    Hardware hardware;
    hardware.spools = {{"b", ratio}};
    for (const char* word : {"M-1-M", "M-1-T-2-M", "M-Y1+1x-Y1-2-M"}) {
      SCOPED_TRACE(word);
      expect_the_same_tensions(routing_of(word), hardware, {});
    }
  }
}

// The finger stands at its stop, and the carriage T/k beyond.
TEST(Mjcf, TheCarriageTravelsTheStretchOfASpring) {
  Hardware hardware = hand_of({simple_finger(9, 70, 60, 4)});
  hardware.tendon = {20000, {}, {{1, 8, {}}}};
  hardware.motor.force_N = 40;
  SimulatedRig rig(mjcf(parse_routing("M-1-F"), hardware));
  rig.pull(40, 4);
  EXPECT_EQ(rig.warnings(), 0);
  EXPECT_NEAR(rig.tensions().at("a"), 40, 0.04);
  const double closed_mm = 2 * 9 * 70 * std::numbers::pi / 180;
  EXPECT_NEAR(rig.position("carriage") * 1000, closed_mm + 40.0 / 8, 0.1);
}

// One spring is on a spool of half the radius, which stretches it half as much.
TEST(Mjcf, SpringsShareTheCarriageByTheirStiffness) {
  Hardware hardware;
  hardware.tendon = {20000, {}, {{1, 2, {}}, {2, 6, {}}}};
  hardware.spools = {{"b", 0.5}};
  SimulatedRig rig(mjcf(parse_routing("1x-M+2x-M"), hardware));
  rig.activate("hold_1");
  rig.activate("hold_2");
  rig.pull(7, 4);
  EXPECT_EQ(rig.warnings(), 0);
  const double travel_mm = 7 / (2 + 0.5 * 0.5 * 6);
  EXPECT_NEAR(rig.position("carriage") * 1000, travel_mm, 0.01);
  EXPECT_NEAR(rig.tensions().at("a"), 2 * travel_mm, 1e-2);
  EXPECT_NEAR(rig.tensions().at("b"), 6 * travel_mm / 2, 1e-2);
}

// Without joints the finger's spring has 500 N/m.
TEST(Mjcf, SecondTendonsPullTheirFingerTogetherOrAgainstEachOther) {
  SimulatedRig flexors(mjcf(parse_routing("M-1x+M2-1x"), {}));
  flexors.pull({10, 4});
  EXPECT_NEAR(flexors.position("runner_1"), 14 / 500.0, 1e-5);
  EXPECT_NEAR(flexors.tensions().at("T1"), 10, 1e-2);
  EXPECT_NEAR(flexors.tensions().at("T2"), 4, 1e-2);
  SimulatedRig antagonists(mjcf(parse_routing("M-1x+M2-1e"), {}));
  antagonists.pull({10, 4});
  EXPECT_NEAR(antagonists.position("runner_1"), 6 / 500.0, 1e-5);
  EXPECT_NEAR(antagonists.position("carriage"), 6 / 500.0, 1e-5);
  EXPECT_NEAR(antagonists.position("carriage_2"), -6 / 500.0, 1e-5);
  EXPECT_NEAR(antagonists.tensions().at("T2"), 4, 1e-2);
  EXPECT_EQ(flexors.warnings() + antagonists.warnings(), 0);
}

TEST(Mjcf, AMotorLetsAnExtensorOutAsFarAsItsFingerCloses) {
  const Hardware hardware = hand_of({simple_finger(25, 90, 60, 4)});
  SimulatedRig rig(mjcf(parse_routing("M-1x+M2-1e"), hardware));
  rig.pull({10, 1}, 4);
  EXPECT_EQ(rig.warnings(), 0);
  const double closed_m = 0.025 * std::numbers::pi / 2;
  EXPECT_NEAR(rig.position("carriage"), closed_m, 1e-4);
  EXPECT_NEAR(rig.position("carriage_2"), -closed_m, 1e-4);
  EXPECT_NEAR(rig.tensions().at("T1"), 10, 1e-2);
  EXPECT_NEAR(rig.tensions().at("T2"), 1, 1e-2);
}

// The extensors are let out, and the flexors pull as they do alone.
TEST(Mjcf, ExtensorsThatFollowAreSlack) {
  for (const char* word : {"1x-P-2x+M2-1e+M2-2e", "M-Y1+1x-Y1-2x+M2-1e+M2-2e"}) {
    SCOPED_TRACE(word);
    SimulatedRig rig(mjcf(parse_routing(word), {}));
    rig.pull({10, 0}, 4);
    EXPECT_EQ(rig.warnings(), 0);
    const Network network = expand(parse_routing(word));
    Grasp grasp;
    grasp.carriages = {2, {1, -1}};
    const TensionState state = tensions(network, mechanics(network, without_friction({})), grasp);
    const auto simulated = rig.tensions();
    for (std::size_t k = 0; k < network.segments.size(); ++k) {
      EXPECT_NEAR(simulated.at(segment_name(network.segments[k])), 10 * state.tension[k], 0.02)
          << segment_name(network.segments[k]);
    }
  }
}

TEST(Mjcf, RefusesSlack) {
  Hardware hardware;
  hardware.tendon = {{}, 40, {{1, {}, 5}}};
  EXPECT_EQ(testing::input_error([&] { mjcf(parse_routing("M-1-F"), hardware); }),
            "hardware: tendon.1.slack_mm = 5: expected none in an export to MuJoCo, whose tendons "
            "are always taut");
}

TEST(Mjcf, MechanismsInPrintOfOneTree) {
  for (const Mechanism& mechanism : testing::shipped_catalogue().mechanisms) {
    const std::vector<std::size_t> all = trees(mechanism.routing);
    if (*std::max_element(all.begin(), all.end()) > 0 || finger_count(mechanism.routing) == 0) {
      continue;
    }
    SCOPED_TRACE(mechanism.name);
    expect_the_same_tensions(mechanism.routing, {}, {});
  }
}

TEST(Mjcf, JointsStandWhereTheirSpringsBalanceTheTendon) {
  // k (q − q0) = r T at each joint, by hand.
  const FingerJoint joint{10, 80, 80, 12, -20, {}};
  const FingerJoint next{8, 90, 44, 10, -15, {}};
  const Hardware hardware = hand_of({{{joint, next}, 5.0}});
  SimulatedRig rig(mjcf(parse_routing("M-1x"), hardware));
  rig.pull(1.5, 6);
  constexpr double rad = std::numbers::pi / 180;
  const double first = 10 * 1.5 / 12 - 20 * rad;
  const double second = 8 * 1.5 / 10 - 15 * rad;
  EXPECT_NEAR(rig.position("finger_1_joint_1"), first, 1e-4);
  EXPECT_NEAR(rig.position("finger_1_joint_2"), second, 1e-4);
  EXPECT_NEAR(rig.position("carriage"), (10 * first + 8 * second) / 1000, 1e-5);
}

TEST(Mjcf, TheCarriageTravelsTheStrokeOfTheHand) {
  const Hardware hardware =
      hand_of({three_joint_finger(), simple_finger(9, 70, 60, 4), simple_finger(12, 60, 50, 4)});
  for (const char* word : {"M-1b-T-2b-B-3b-M", "M-1-Y1+2-Y1-3-T-2", "1-P-2-P-3-P-1"}) {
    SCOPED_TRACE(word);
    const Routing routing = parse_routing(word);
    const Network network = expand(routing);
    Kinematics kinematics;
    Motion motion;
    const HandClosing closing =
        close_hand(*hand(hardware), network, mechanics(network, hardware), kinematics, motion);
    SimulatedRig rig(mjcf(routing, hardware));
    rig.pull(40, 4);
    EXPECT_EQ(rig.warnings(), 0);
    EXPECT_NEAR(rig.position("carriage") * 1000, closing.stroke_mm, 0.01 * closing.stroke_mm);
  }
}

TEST(Mjcf, HeldFingersStand) {
  const Hardware hardware = hand_of({three_joint_finger(), simple_finger(9, 70, 60, 4)});
  SimulatedRig rig(mjcf(parse_routing("M-1-T-2-F"), hardware));
  rig.activate("hold_1");
  rig.pull(20);
  for (const char* joint : {"finger_1_joint_1", "finger_1_joint_2", "finger_1_joint_3"}) {
    EXPECT_NEAR(rig.position(joint), 0, 1e-3) << joint;
  }
  EXPECT_NEAR(rig.position("finger_2_joint_1"), 70 * std::numbers::pi / 180, 0.02);
}

TEST(Mjcf, SaysWhatOfTheFrictionItCannotCarry) {
  const std::string text = mjcf(parse_routing("M-1-F"), {});
  EXPECT_NE(text.find("no capstan friction"), std::string::npos);
  EXPECT_EQ(SimulatedRig(text).text("contact_T1_T2"),
            "tube: mu 0.18, angle 3.14159265 rad, exponent 0.565486678");
}

TEST(Mjcf, HasTheTwoContactsOfALoopApart) {
  Hardware hardware;
  hardware.contacts = {{"T1", "T2", 0.3, 2.0}, {"T2", "T1", 0.05, 4.0}};
  const SimulatedRig rig(mjcf(parse_routing("M-Y1+1-Y1-1"), hardware));
  EXPECT_EQ(rig.text("contact_T1_T2"), "tube: mu 0.3, angle 2 rad, exponent 0.6");
  EXPECT_EQ(rig.text("contact_T2_T1"), "block: mu 0.05, angle 4 rad, exponent 0.2");
}

TEST(Mjcf, RefusesWhatHasNoTensions) {
  EXPECT_NE(testing::out_of_range([] {
              mjcf(parse_routing("Y1-P-Y2+1x-Y1-T-Y2-2x"), {});
            }).find("blocks are free to move against each other"),
            std::string::npos);
}

}  // namespace
}  // namespace reeve
