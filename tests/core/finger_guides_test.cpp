#include "core/finger_guides.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/contact_name.hpp"
#include "core/hand.hpp"
#include "core/performance.hpp"
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
  const Mechanics parts = mechanics(net, hardware);
  return finger_pulls_of(net, parts, tensions(net, parts, grasp));
}

void set_exponent(Mechanics& parts, std::size_t contact, double phi) {
  parts.phi[contact] = phi;
  parts.decay[contact] = std::exp(-phi);
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

// The flexor's pull falls towards the tip, the extensor's rises.
TEST(FingerGuides, ServeAnExtensorAgainstTheFlexor) {
  const FingerPull pull{2, -0.3};
  EXPECT_DOUBLE_EQ(pull.sum_N(), 1.7);
  EXPECT_DOUBLE_EQ(pull.behind_guide_N(std::exp(-0.4)), 2 * std::exp(-0.4) - 0.3 * std::exp(0.4));
  Grasp grasp;
  grasp.carriages = {2, {1, 0.1}};
  const Network net = network_of("M-1x+1e-P2-2x");
  const TensionState state = tensions(net, mechanics(net, Hardware{}), grasp);
  const FingerPullArray pulls = pulls_in("M-1x+1e-P2-2x", Hardware{}, grasp);
  EXPECT_LT(pulls[1].right_N, 0);
  for (const std::size_t f : {1U, 2U}) EXPECT_EQ(pulls[f].sum_N(), pulls_by_finger(net, state)[f]);
  EXPECT_DOUBLE_EQ((FingerPull{2, 0.3}.behind_guide_N(std::exp(-0.4))), 2.3 * std::exp(-0.4));
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
  const Hardware hardware = hand_of({guided_finger()});
  const FingerPull pull = pulls_in("M-1-F", hardware, {})[1];
  const double decay = std::exp(-0.18 * in_rad(90));
  EXPECT_NEAR(pull.behind_guide_N(decay), pull.left_N * decay + pull.right_N / decay, 1e-12);
}

// The tendon goes in along strand 1, past both guides, round the tip and past them again.
TEST(FingerGuides, ArePassedTwiceByATendonThatComesBack) {
  const Hardware hardware = hand_of({guided_finger()});
  const FingerPull pull = pulls_in("M-1-F", hardware, {})[1];
  const double loss = std::exp(-hardware.tube.exponent() - 2 * 0.18 * in_rad(90));
  EXPECT_NEAR(pull.right_N / pull.left_N, loss, 1e-12);
}

// As the finger opens, the tendon goes the other way past all of them. The ratio at the palm of a
// tendon with an end F is that of two such ends beside a pulley of the carriage, too.
TEST(FingerGuides, ArePassedTwiceInReleaseAsWell) {
  const Hardware hardware = hand_of({guided_finger(), guided_finger()});
  const double gain = std::exp(hardware.bearing.exponent() + 2 * 0.18 * in_rad(90));
  const auto ratio = [&](const std::string& word, int far, int near) {
    const Network net = network_of(word);
    const TensionState state = tensions(net, mechanics(net, hardware), {}, Direction::release);
    const auto at = [&](int strand) {
      return state.tension[*find_segment(net, *segment_named("T" + std::to_string(strand)))];
    };
    return at(far) / at(near);
  };
  EXPECT_NEAR(ratio("M-1b-F", 2, 1), gain, 1e-12);
  EXPECT_NEAR(ratio("F-1b-P-2b-F", 1, 2), gain, 1e-12);
  EXPECT_NEAR(ratio("M-Y1+F-1b-Y1-2b-F", 1, 2), gain, 1e-12);
}

// Without friction at the guides nothing decides what goes round the loop otherwise.
TEST(FingerGuides, LetALoopThatPassesABlockGoRound) {
  const auto tensions_at = [](double mu) {
    Hardware hardware = hand_of({guided_finger(), guided_finger()});
    for (FingerJoint& joint : hardware.fingers[0].parts.joints) joint.mu = mu;
    for (FingerJoint& joint : hardware.fingers[1].parts.joints) joint.mu = mu;
    const Network net = network_of("M-Y1+1b-Y1-2b-P-1b");
    const TensionState state = tensions(net, mechanics(net, hardware), {});
    EXPECT_TRUE(state.in_range) << mu;
    return state.tension;
  };
  const std::vector<double> without = tensions_at(0);
  const std::vector<double> with_little = tensions_at(1e-6);
  for (std::size_t i = 0; i < without.size(); ++i) EXPECT_NEAR(with_little[i], without[i], 1e-4);
  for (const double mu : {0.01, 0.03, 0.1, 0.2}) tensions_at(mu);
}

TEST(FingerGuides, LoadBothStrandsFromThePalmWhereBothArePulled) {
  const FingerPull pull = pulls_in("M-1-M", hand_of({guided_finger()}), {})[1];
  EXPECT_NEAR(pull.sum_N(), std::exp(-0.18 * 2 * 3.14159265358979), 1e-9);
  EXPECT_NEAR(pull.behind_guide_N(0.7), 0.7 * pull.sum_N(), 1e-12);
}

// Both strands slide to the palm past the guides, so that friction there costs the fingertip what
// it takes from each strand, and the motor no less for it.
TEST(FingerGuides, ThatBothStrandsSlideToThePalmPastChangeNothingBetweenThem) {
  Hardware hardware = hand_of({guided_finger()});
  hardware.tube.mu = 0;
  hardware.sheath.mu = 0;
  hardware.contacts = {{"a", "T1", 0.5, 2.0}};
  double before_N = 0;
  for (const double mu : {0.0, 0.1, 0.2}) {
    for (FingerJoint& joint : hardware.fingers[0].parts.joints) joint.mu = mu;
    const FingerPull pull = pulls_in("M-1-M", hardware, {})[1];
    EXPECT_NEAR(pull.left_N, 1 / (1 + std::exp(1.0)), 1e-12);
    EXPECT_NEAR(pull.right_N, pull.left_N, 1e-12);
    const double last = std::exp(-mu * in_rad(90));
    EXPECT_NEAR(pull.behind_guide_N(last), last * pull.sum_N(), 1e-12);
    const double force_N = motor_force(hand(hardware)->finger(1), true, pull);
    EXPECT_GT(force_N, before_N);
    before_N = force_N;
  }
}

// A strand that hangs on no tip contact has only its own palm end.
TEST(FingerGuides, LoadAStrandThatIsTiedAtTheFingertipFromThePalm) {
  const FingerPull pull = pulls_in("M-1x", hand_of({guided_finger()}), {})[1];
  EXPECT_EQ(pull.tip_decay, 0);
  EXPECT_NEAR(pull.behind_guide_N(0.7), 0.7 * pull.sum_N(), 1e-12);
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

// Contacts alone change friction by this factor.
TEST(FingerGuides, ChangeWithTheExponentOfTheirTip) {
  const Hardware hardware = hand_of({guided_finger()});
  const Network net = network_of("M-1-F");
  Mechanics parts = mechanics(net, hardware);
  const std::size_t tip = find_contact(net, "T1-T2").value();
  set_exponent(parts, tip, 1.5 * parts.phi[tip]);
  const FingerPull pull = finger_pulls_of(net, parts, tensions(net, parts, {}))[1];
  EXPECT_NEAR(pull.behind_guide_N(0.9),
              pull.left_N * std::pow(0.9, 1.5) + pull.right_N / std::pow(0.9, 1.5), 1e-12);
}

// At the end of the range the guides take more, round the tip, too.
TEST(FingerGuides, KeepTheConeOfTheTipAtTheEndOfTheRange) {
  Hardware hardware = hand_of({guided_finger()});
  hardware.tube.mu = 0;
  for (FingerJoint& joint : hardware.fingers[0].parts.joints) {
    joint.mu = 0.1;
    joint.spring_Nmm_rad = 500;
  }
  const HandFinger finger = hand(hardware)->finger(1);
  const FingerPull pull = pulls_in("M-1-F", hardware, {})[1];
  const double last = finger.demands[1].closed_decay;
  EXPECT_NEAR(motor_force(finger, false, pull),
              finger.demands[1].close_N / (2 * pull.left_N * last), 1e-9);
}

// Three joints of 55° with tubes of mu 0.1, no other friction.
Hardware hand_without_other_friction() {
  Hardware hardware;
  for (ContactLaw* law : {&hardware.tube, &hardware.bearing, &hardware.sheath}) law->mu = 0;
  FingerParts& parts = hardware.finger_parts;
  parts.force_N = 5;
  parts.joints = {{10, 80, 60, 0, 0, 55.0}, {8, 80, 40, 20, -10, 55.0}, {6, 80, 20, 0, 0, 55.0}};
  for (FingerJoint& joint : parts.joints) {
    joint.guide = JointGuide::tube;
    joint.mu = 0.1;
  }
  return hardware;
}

// Joint 1 gives first: it feels what one guide leaves of the strand from the palm, and what five
// guides leave in the strand that comes back.
TEST(FingerGuides, OfAHeldFingerLetTheTighterStrandLoadTheOtherRoundTheTip) {
  const Hardware hardware = hand_without_other_friction();
  const double phi = 0.1 * in_rad(55);
  const double pull = std::exp(-phi) + std::exp(-5 * phi);
  struct Case {
    const char* word;
    int held;
    double palm_N;
  };
  for (const Case& one : {Case{"M-1-F", 1, 1}, Case{"M-1b-B-2b-F", 2, std::exp(-6 * phi)}}) {
    const Network net = network_of(one.word);
    const Mechanics parts = mechanics(net, hardware);
    const Grasp grasp = hold({one.held});
    const GripDemand demand =
        grip_demand(*hand(hardware), net.fingers, testing::pulls_in(net, parts, grasp), grasp);
    EXPECT_NEAR(demand.force_per_motor_N, one.palm_N * pull * 10 / 60, 1e-9) << one.word;
    EXPECT_NEAR(demand.motor_force_N, 60 * 5 / (one.palm_N * pull * 10), 1e-9) << one.word;
    EXPECT_EQ(demand.weakest, one.held);
  }
}

}  // namespace
}  // namespace reeve
