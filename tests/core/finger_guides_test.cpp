#include "core/finger_guides.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/hand.hpp"
#include "tests/core/network_of.hpp"
#include "tests/support/example_hand.hpp"

namespace reeve {
namespace {

using testing::hand_of;
using testing::network_of;
using testing::simple_finger;

// Two joints of 30° in the holding posture, wraps of 20° and 10°.
FingerParts guided_finger() {
  FingerParts parts{{{10, 80, 60, 0, 0, 30.0}, {8, 80, 30, 0, 0, 30.0}}, 5.0};
  for (FingerJoint& joint : parts.joints) joint.guide = JointGuide::tube;
  parts.joints[0].wrap_deg = 20;
  parts.joints[1].wrap_deg = 10;
  return parts;
}

FingerPullArray pulls_in(const std::string& word, const Hardware& hardware, Grasp grasp) {
  const Network net = network_of(word);
  return finger_pulls_of(net, tensions(net, mechanics(net, hardware), grasp));
}

TEST(FingerGuides, TakeTheCoefficientOfTheirKindUnlessTheyHaveTheirOwn) {
  Hardware hardware;
  std::vector<FingerJoint> joints = guided_finger().joints;
  joints[1].guide = JointGuide::pulley;
  EXPECT_EQ(with_guide_coefficients(joints, hardware)[0].mu, hardware.tube.mu);
  EXPECT_EQ(with_guide_coefficients(joints, hardware)[1].mu, hardware.bearing.mu);
  joints[0].mu = 0.3;
  EXPECT_EQ(with_guide_coefficients(joints, hardware)[0].mu, 0.3);
}

TEST(FingerGuides, LeaveLessToTheDistalJoint) {
  const HandFinger finger = hand(hand_of({guided_finger()}))->finger(1);
  const double first = std::exp(-0.18 * in_rad(50));
  const double second = first * std::exp(-0.18 * in_rad(40));
  EXPECT_NEAR(force_without_springs(finger, {12}), 12 * std::min(first * 10 / 60, second * 8 / 30),
              1e-12);
  EXPECT_NEAR(held_force(finger, {1}, 12).force_N, force_without_springs(finger, {12}), 1e-12);
  EXPECT_NEAR(motor_force(finger, true, {1}), 5 * std::max(60 / (10 * first), 30 / (8 * second)),
              1e-10);
}

TEST(FingerGuides, LeaveMoreToTheDistalJointWhereTheTendonSlidesToTheTip) {
  const HandFinger finger = hand(hand_of({guided_finger()}))->finger(1);
  const FingerPull outward{0, 12};
  EXPECT_NEAR(outward.behind_guide_N(finger.demands[1].held_decay),
              12 * std::exp(0.18 * in_rad(90)), 1e-12);
}

// The tendon goes in along strand 1, past both guides, round the tip and past them again.
TEST(FingerGuides, ArePassedTwiceByATendonThatComesBack) {
  const Hardware hardware = hand_of({guided_finger()});
  const FingerPull pull = pulls_in("M-1-F", hardware, {})[1];
  const double loss = std::exp(-hardware.tube.exponent() - 2 * 0.18 * in_rad(90));
  EXPECT_NEAR(pull.outward_N / pull.inward_N, loss, 1e-12);
}

TEST(FingerGuides, SeeBothStrandsSlideToThePalmWhereBothArePulled) {
  const FingerPull pull = pulls_in("M-1-M", hand_of({guided_finger()}), {})[1];
  EXPECT_EQ(pull.outward_N, 0);
  EXPECT_NEAR(pull.inward_N, std::exp(-0.18 * 2 * 3.14159265358979), 1e-9);
}

TEST(FingerGuides, DoNotChangeAHandThatHasNone) {
  const Hardware plain = hand_of({simple_finger(8, 90, 60, 5), simple_finger(10, 70, 50, 6)});
  Hardware frictionless = plain;
  for (FingerHardware& finger : frictionless.fingers) {
    finger.parts.joints[0].guide = JointGuide::tube;
    finger.parts.joints[0].mu = 0;
  }
  const FingerPullArray a = pulls_in("M-1-T-2-F", plain, {});
  const FingerPullArray b = pulls_in("M-1-T-2-F", frictionless, {});
  for (const std::size_t f : {1U, 2U}) EXPECT_EQ(a[f].sum_N(), b[f].sum_N());
}

}  // namespace
}  // namespace reeve
