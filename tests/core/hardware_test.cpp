#include "core/hardware.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/mechanics.hpp"
#include "tests/core/network_of.hpp"
#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

using std::numbers::pi;
using testing::network_of;

// Friction exponents along the walk.
std::vector<double> phi(const std::string& word, const Hardware& hardware) {
  return mechanics(network_of(word), hardware).phi;
}

std::vector<double> lengths(const std::string& word, const Hardware& hardware) {
  return mechanics(network_of(word), hardware).length;
}

// Exponents that tell every kind of contact apart: tube 0.1, bearing 0.01, sheath 1.
Hardware simple_hardware() {
  Hardware hardware;
  hardware.tube = {0.1, 1};
  hardware.bearing = {0.01, 1};
  hardware.sheath = {0.5, 2};
  return hardware;
}

FingerHardware only_finger(int number) {
  FingerHardware finger;
  finger.finger = number;
  return finger;
}

using Values = std::vector<double>;

TEST(Hardware, DefaultsAreThePapersCoefficients) {
  const Values expected{0.18 * 2 * pi, 0.18 * pi, 0.18 * 2 * pi, 0.001 * pi, 0.18 * 2 * pi};
  EXPECT_EQ(phi("M-1-P-F", Hardware{}), expected);
  EXPECT_EQ(lengths("M-1-T-P-F", Hardware{}), Values(7, 100));
}

TEST(Hardware, EachContactHasTheExponentOfItsKind) {
  EXPECT_EQ(phi("M-1-T-2b-B-3-P-4-F", simple_hardware()),
            (Values{1, 0.1, 0.1, 0.01, 0.01, 0.1, 1, 0.01, 1, 0.1}));
}

TEST(Hardware, DecayIsTheExponentialOfMinusTheExponent) {
  const Mechanics m = mechanics(network_of("M-1-T-2b-P-3-F"), simple_hardware());
  ASSERT_EQ(m.decay.size(), m.phi.size());
  for (std::size_t k = 0; k < m.phi.size(); ++k) EXPECT_EQ(m.decay[k], std::exp(-m.phi[k]));
}

TEST(Hardware, EachSegmentHasTheLengthOfItsKind) {
  Hardware hardware;
  hardware.strand_mm = 80;
  hardware.motor_side_mm = 500;
  hardware.hand_mm = 20;
  EXPECT_EQ(lengths("M-1-T-B-F", hardware), (Values{500, 80, 80, 20, 20}));
}

TEST(Hardware, FingersCloseAlikeUnlessToldOtherwise) {
  Hardware hardware;
  hardware.fingers = {only_finger(3)};
  hardware.fingers[0].closing = 2.5;
  EXPECT_EQ(mechanics(network_of("M-1-T-2-T-3-F"), hardware).closing, (Values{1, 1, 2.5}));
}

TEST(HardwareFinger, OverridesItsTipAndItsSheathsOnly) {
  Hardware hardware = simple_hardware();
  FingerHardware second = only_finger(2);
  second.tip_mu = 0.3;
  second.sheath_mu = 0.25;
  hardware.fingers = {second};
  EXPECT_EQ(phi("M-1-P-2-T-3-M", hardware), (Values{1, 0.1, 1, 0.01, 0.5, 0.3, 0.1, 0.1, 1}));
}

TEST(HardwareFinger, AnglesMultiplyTheCoefficientOfTheKind) {
  Hardware hardware = simple_hardware();
  FingerHardware first = only_finger(1);
  first.tip_angle_rad = 3;
  first.sheath_angle_rad = 6;
  hardware.fingers = {first};
  const Values found = phi("M-1b-M", hardware);
  EXPECT_DOUBLE_EQ(found[0], 3);
  EXPECT_DOUBLE_EQ(found[1], 0.03);
  EXPECT_DOUBLE_EQ(found[2], 3);
}

TEST(HardwareFinger, OverridesTheLengthOfItsStrands) {
  Hardware hardware;
  FingerHardware second = only_finger(2);
  second.strand_mm = 60;
  hardware.fingers = {second};
  EXPECT_EQ(lengths("M-1-T-2-F", hardware), (Values{100, 100, 100, 60, 60}));
}

TEST(HardwareFinger, MayBeAFingerThatThisRoutingDoesNotHave) {
  Hardware hardware;
  hardware.fingers = {only_finger(5)};
  EXPECT_EQ(phi("M-1-F", hardware), phi("M-1-F", Hardware{}));
}

TEST(HardwareContact, OverridesOneContactInEitherOrder) {
  Hardware hardware = simple_hardware();
  const Values expected{1, 0.1, 0.4, 0.1};
  hardware.contacts = {{"T2", "T3", 0.4, {}}};
  EXPECT_EQ(phi("M-1-T-2-F", hardware), expected);
  hardware.contacts = {{"T3", "T2", 0.4, {}}};
  EXPECT_EQ(phi("M-1-T-2-F", hardware), expected);
}

TEST(HardwareContact, MayGiveTheAngleOnly) {
  Hardware hardware = simple_hardware();
  hardware.contacts = {{"a", "T1", {}, 4.0}};
  EXPECT_EQ(phi("M-1-T-2-F", hardware), (Values{2, 0.1, 0.1, 0.1}));
}

TEST(HardwareContact, ReachesMotorSidesHandStretchesAndTheContactThatClosesALoop) {
  Hardware hardware = simple_hardware();
  hardware.contacts = {{"b", "a", 0.3, {}}, {"T1", "T2", 0.6, {}}};
  EXPECT_EQ(phi("1-T-2-P-1", hardware), (Values{0.1, 0.1, 1, 0.3, 1, 0.6}));
  hardware.contacts = {{"h1", "a", 0, {}}, {"h2", "h1", 0.7, {}}};
  EXPECT_EQ(phi("M-T-F", hardware), (Values{0, 0.7}));
}

TEST(HardwareContact, GoesBeforeItsFinger) {
  Hardware hardware = simple_hardware();
  FingerHardware first = only_finger(1);
  first.tip_mu = 0.3;
  first.tip_angle_rad = 2;
  hardware.fingers = {first};
  hardware.contacts = {{"T1", "T2", 0.4, {}}};
  EXPECT_EQ(phi("M-1-F", hardware), (Values{1, 0.8}));
}

TEST(HardwareContact, IsReportedIfNoContactHasItsName) {
  Hardware hardware;
  hardware.contacts = {
      {"T2", "T3", 0.1, {}}, {"T1", "T3", 0.1, {}}, {"b", "T4", 0.1, {}}, {"h1", "a", 0.1, {}}};
  const MechanicsBuilder builder(hardware);
  EXPECT_EQ(builder.unmatched_contacts(network_of("M-1-T-2-F")),
            (std::vector<std::string>{"T1-T3", "b-T4", "h1-a"}));
  EXPECT_EQ(builder.unmatched_contacts(network_of("M-1-T-2-M")),
            (std::vector<std::string>{"T1-T3", "h1-a"}));
}

TEST(HardwareContact, ASegmentMustHaveAName) {
  for (const std::string segment :
       {"", "T", "T0", "T01", "h0", "A", "a1", "1", "strand 1", "T1x"}) {
    Hardware hardware;
    hardware.contacts = {{"a", segment, 0.1, {}}};
    EXPECT_EQ(testing::input_error([&] { MechanicsBuilder builder(hardware); }),
              "hardware: contact: segment '" + segment +
                  "': expected a strand (T1), a motor-side segment (a) or a stretch at the hand "
                  "(h1)");
  }
}

TEST(Hardware, ABuilderForgetsTheNetworkBefore) {
  Hardware hardware = simple_hardware();
  hardware.contacts = {{"T1", "T2", 0.4, {}}};
  const MechanicsBuilder builder(hardware);
  Mechanics reused;
  builder.apply(network_of("1-P-2-P-1+M-3-F"), reused);
  builder.apply(network_of("M-1-F"), reused);
  EXPECT_EQ(reused.phi, (Values{1, 0.4}));
  EXPECT_EQ(reused.length.size(), 3U);
  EXPECT_EQ(reused.closing.size(), 1U);
}

// ---- what is out of range ----

std::string message(const std::function<void(Hardware&)>& spoil) {
  Hardware hardware;
  spoil(hardware);
  return testing::input_error([&] { validate(hardware); });
}

std::string finger_message(const std::function<void(FingerHardware&)>& spoil) {
  FingerHardware second = only_finger(2);
  spoil(second);
  return message([&](Hardware& h) { h.fingers = {second}; });
}

TEST(HardwareError, NamesTheCoefficientItsValueAndItsRange) {
  EXPECT_EQ(message([](Hardware& h) { h.tube.mu = -0.1; }),
            "hardware: tube.mu = -0.1: expected a number from 0 to 10");
  EXPECT_EQ(message([](Hardware& h) { h.bearing.mu = 11; }),
            "hardware: bearing.mu = 11: expected a number from 0 to 10");
  EXPECT_EQ(message([](Hardware& h) { h.sheath.angle_rad = -1; }),
            "hardware: sheath.angle_rad = -1: expected a number from 0 to 1000 rad");
}

TEST(HardwareError, NotANumberIsOutOfEveryRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message([&](Hardware& h) { h.tube.mu = nan; }),
            "hardware: tube.mu = nan: expected a number from 0 to 10");
  EXPECT_EQ(message([&](Hardware& h) { h.hand_mm = nan; }),
            "hardware: lengths.hand_mm = nan: expected a number from 0.001 to 1000000 mm");
  EXPECT_EQ(message([&](Hardware& h) { h.sheath.angle_rad = 1 / 0.0; }),
            "hardware: sheath.angle_rad = inf: expected a number from 0 to 1000 rad");
}

TEST(HardwareError, NamesTheLength) {
  EXPECT_EQ(message([](Hardware& h) { h.strand_mm = 0; }),
            "hardware: lengths.strand_mm = 0: expected a number from 0.001 to 1000000 mm");
  EXPECT_EQ(message([](Hardware& h) { h.motor_side_mm = -5; }),
            "hardware: lengths.motor_side_mm = -5: expected a number from 0.001 to 1000000 mm");
}

TEST(HardwareError, AnExponentBeyondAnyContactIsRefused) {
  EXPECT_EQ(message([](Hardware& h) {
              h.tube = {2, 6};
            }),
            "hardware: tube: mu * angle = 12: expected at most 10");
  EXPECT_EQ(message([](Hardware& h) { h.tube = {2, 5}; }), "no such error was thrown");
}

TEST(HardwareError, NamesTheFinger) {
  EXPECT_EQ(finger_message([](FingerHardware& f) { f.finger = 0; }),
            "hardware: finger number = 0: expected a number from 1 to 64");
  EXPECT_EQ(finger_message([](FingerHardware& f) { f.finger = 65; }),
            "hardware: finger number = 65: expected a number from 1 to 64");
  EXPECT_EQ(finger_message([](FingerHardware& f) { f.tip_mu = -1; }),
            "hardware: finger.2.tip_mu = -1: expected a number from 0 to 10");
  EXPECT_EQ(finger_message([](FingerHardware& f) { f.tip_angle_rad = -1; }),
            "hardware: finger.2.tip_angle_rad = -1: expected a number from 0 to 1000 rad");
  EXPECT_EQ(finger_message([](FingerHardware& f) { f.sheath_mu = -1; }),
            "hardware: finger.2.sheath_mu = -1: expected a number from 0 to 10");
  EXPECT_EQ(finger_message([](FingerHardware& f) { f.sheath_angle_rad = 1001; }),
            "hardware: finger.2.sheath_angle_rad = 1001: expected a number from 0 to 1000 rad");
  EXPECT_EQ(finger_message([](FingerHardware& f) { f.strand_mm = 0; }),
            "hardware: finger.2.strand_mm = 0: expected a number from 0.001 to 1000000 mm");
  EXPECT_EQ(finger_message([](FingerHardware& f) { f.closing = 0; }),
            "hardware: finger.2.closing = 0: expected a number from 0.001 to 1000");
}

TEST(HardwareError, AFingersExponentsAreThoseWithItsOverrides) {
  EXPECT_EQ(finger_message([](FingerHardware& f) { f.tip_mu = 4; }),
            "hardware: finger.2 tip: mu * angle = " + std::string("12.566370614359172") +
                ": expected at most 10");
  EXPECT_EQ(finger_message([](FingerHardware& f) {
              f.sheath_mu = 5;
              f.sheath_angle_rad = 3;
            }),
            "hardware: finger.2 sheath: mu * angle = 15: expected at most 10");
  // Whichever tip the finger has in a routing: here a tube would do, a bearing would not.
  EXPECT_EQ(message([](Hardware& h) {
              h.bearing = {4, 2};
              FingerHardware second = only_finger(2);
              second.tip_angle_rad = 3;
              h.fingers = {second};
            }),
            "hardware: finger.2 tip: mu * angle = 12: expected at most 10");
}

TEST(HardwareError, NamesTheContact) {
  EXPECT_EQ(message([](Hardware& h) {
              h.contacts = {{"a", "T1", -1.0, {}}};
            }),
            "hardware: contact.a-T1.mu = -1: expected a number from 0 to 10");
  EXPECT_EQ(message([](Hardware& h) {
              h.contacts = {{"T2", "T3", {}, 2000.0}};
            }),
            "hardware: contact.T2-T3.angle_rad = 2000: expected a number from 0 to 1000 rad");
}

TEST(HardwareError, AContactsExponentIsKnownOnceTheNetworkIs) {
  Hardware hardware;
  hardware.contacts = {{"T2", "T1", 9.0, 2.0}};
  EXPECT_EQ(testing::out_of_range([&] { mechanics(network_of("M-1-F"), hardware); }),
            "hardware: T1-T2: mu * angle = 18: expected at most 10");
}

// The nearest that the file says something of.
TEST(HardwareError, NamesTheFileAndItsPlace) {
  Hardware hardware;
  hardware.origin = std::make_shared<const HardwareOrigin>(HardwareOrigin{
      "h.toml",
      {{"block.mu", "h.toml:2:1"}, {"finger.1", "h.toml:4:2"}, {"contact.T2-T1", "h.toml:6:2"}}});
  const auto refused = [&](auto change) {
    Hardware changed = hardware;
    change(changed);
    return testing::input_error([&] { validate(changed); });
  };
  EXPECT_EQ(refused([](Hardware& h) {
              h.block = {11, 1};
            }),
            "h.toml:2:1: hardware: block.mu = 11: expected a number from 0 to 10");
  EXPECT_EQ(refused([](Hardware& h) { h.tube.mu = 11; }),
            "h.toml: hardware: tube.mu = 11: expected a number from 0 to 10");
  EXPECT_EQ(refused([](Hardware& h) {
              h.fingers.push_back({1, 11.0, {}, {}, {}, {}, {}});
            }),
            "h.toml:4:2: hardware: finger.1.tip_mu = 11: expected a number from 0 to 10");
  EXPECT_EQ(refused([](Hardware& h) {
              h.fingers.push_back({12, 11.0, {}, {}, {}, {}, {}});
            }),
            "h.toml: hardware: finger.12.tip_mu = 11: expected a number from 0 to 10");
  EXPECT_EQ(refused([](Hardware& h) { h.motor.close_s = 0; }),
            "h.toml: hardware: motor.close_s = 0: expected a number from 0.001 to 3600 s");
  hardware.contacts = {{"T2", "T1", 9.0, 2.0}};
  EXPECT_EQ(testing::out_of_range([&] { mechanics(network_of("M-1-F"), hardware); }),
            "h.toml:6:2: hardware: T1-T2: mu * angle = 18: expected at most 10");
}

TEST(HardwareError, ABuilderTakesValidHardwareOnly) {
  Hardware hardware;
  hardware.tube.mu = -1;
  EXPECT_EQ(testing::input_error([&] { MechanicsBuilder builder(hardware); }),
            "hardware: tube.mu = -1: expected a number from 0 to 10");
}

}  // namespace
}  // namespace reeve
