// Wrap angles that a word gives: B/90.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/canonical.hpp"
#include "core/mechanics.hpp"
#include "core/tension/tension.hpp"
#include "tests/core/network_of.hpp"
#include "tests/support/input_error.hpp"

namespace reeve::testing {
namespace {

using std::numbers::pi;

double tension_of(const std::string& word, const char* segment, const Hardware& hardware = {}) {
  const Network network = network_of(word);
  const TensionState state = tensions(network, mechanics(network, hardware), Grasp{});
  return state.tension[*find_segment(network, *segment_named(segment))];
}

std::string identical(const std::string& word) {
  return to_word(canonical(parse_routing(word), FingerIdentity::identical));
}

std::string error_of(const std::string& word) {
  return input_error([&] { parse_routing(word); });
}

TEST(WrapAngle, IsPrintedAsItWasRead) {
  for (const char* word :
       {"M-1/170-T/120-2b/0.5-B/90-3-F", "M-1-P/90-2-P2/45.125-3-M2", "M-Y1+1x-Y1/180-2x",
        "1/170-T/3600-1/170", "M-1-T/0.001-F", "1x-W1/2:1-2x+M-W1"}) {
    EXPECT_EQ(to_word(parse_routing(word)), word);
  }
}

// Pulled, and no finger held: T1 = e^{-sheath}, T2 and T3 behind the tip and the join.
TEST(WrapAngle, SetsTheExponentOfItsContactAlone) {
  const double sheath = 0.18 * 2 * pi;
  EXPECT_NEAR(tension_of("M-1/170-T/120-2-F", "T2"), std::exp(-sheath - 0.18 * 170 * pi / 180),
              1e-14);
  EXPECT_NEAR(tension_of("M-1/170-T/120-2-F", "T3"), std::exp(-sheath - 0.18 * 290 * pi / 180),
              1e-14);
  EXPECT_NEAR(tension_of("M-1/170-T/120-2-F", "T4"),
              std::exp(-sheath - 0.18 * (290 * pi / 180 + pi)), 1e-14);
  EXPECT_EQ(mechanics(network_of("1/45-T/90-1/45"), Hardware{}).phi,
            (std::vector<double>{0.18 * pi / 2, 0.18 * pi / 4}));
}

TEST(WrapAngle, OfAMovablePulleyLeavesItsSheaths) {
  EXPECT_EQ(
      mechanics(network_of("F-1-P/90-2-F"), Hardware{}).phi,
      (std::vector<double>{0.18 * pi, 0.18 * 2 * pi, 0.001 * pi / 2, 0.18 * 2 * pi, 0.18 * pi}));
}

struct Equal {
  const char* word;
  const char* plain;
  ContactHardware contact;
};

TEST(WrapAngle, IsTheSameAsThatOfTheHardwareFile) {
  const std::vector<Equal> cases{
      {"M-1/170-T-2-F", "M-1-T-2-F", {"T1", "T2", {}, 170 * pi / 180}},
      {"M-1-T/120-2-F", "M-1-T-2-F", {"T2", "T3", {}, 120 * pi / 180}},
      {"M-1-B/22.5-2-F", "M-1-B-2-F", {"T2", "T3", {}, 22.5 * pi / 180}},
      {"M-1-P/90-2-M", "M-1-P-2-M", {"b", "c", {}, 90 * pi / 180}},
      {"M-Y1+1x-Y1/160-2x", "M-Y1+1x-Y1-2x", {"T1", "T3", {}, 160 * pi / 180}}};
  for (const Equal& one : cases) {
    Hardware hardware;
    hardware.contacts = {one.contact};
    EXPECT_EQ(mechanics(network_of(one.word), {}).phi,
              mechanics(network_of(one.plain), hardware).phi)
        << one.word;
  }
}

TEST(WrapAngle, GoesBeforeThatOfTheHardwareFile) {
  Hardware hardware;
  hardware.tube.mu = 0.1;
  hardware.contacts = {{"T1", "T2", 0.2, 9.0}};
  FingerHardware finger;
  finger.finger = 1;
  finger.tip_angle_rad = 8;
  hardware.fingers = {finger};
  EXPECT_EQ(mechanics(network_of("M-1/90-F"), hardware).phi[1], 0.2 * pi / 2);
}

TEST(WrapAngle, IsPartOfTheCanonicalWord) {
  EXPECT_EQ(identical("F-2-T/90-1-M"), "M-1-T/90-2-F");
  EXPECT_NE(identical("M-1-T/90-2-F"), identical("M-1-T-2-F"));
  EXPECT_EQ(identical("M-1/90-T-2-M"), identical("M-1-T-2/90-M"));
  EXPECT_EQ(identical("2/90-T-1-P-2/90"), identical("1-P-2/90-T-1"));
  EXPECT_EQ(identical("M-Y1+1x-Y1/90-2x"), identical("M-Y3+2x-Y3/90-1x"));
  EXPECT_NE(identical("M-Y1+1x-Y1/90-2x"), identical("M-Y1+1x-Y1-2x"));
}

TEST(WrapAngle, IsRefusedWithTheTokenAndWhatWasExpected) {
  const std::string angle =
      ": expected behind / the wrap angle in degrees, from 0.001 to 3600 with at most three "
      "decimals and no needless zeros, such as B/90";
  for (const char* token : {"B/", "B/x", "B/0", "B/1e99", "B/3601", "B/nan", "B/inf", "B/90.0",
                            "B/090", "B/ 9", "B/1.2345", "B/90/90", "B/0.0001"}) {
    EXPECT_EQ(error_of("M-1-" + std::string(token) + "-2-F"),
              "routing 'M-1-" + std::string(token) + "-2-F', column 5: '" + token + "'" + angle);
  }
  EXPECT_EQ(error_of("M-1-B/-1-2-F"), "routing 'M-1-B/-1-2-F', column 5: 'B/'" + angle);
  const auto alone = [](const std::string& token) {
    return ": expected " + token +
           " alone: a wrap angle belongs to a finger, T, B, P or a block inside a walk";
  };
  EXPECT_EQ(error_of("M/90-1-F"), "routing 'M/90-1-F', column 1: 'M/90'" + alone("M"));
  EXPECT_EQ(error_of("M-1x/90"), "routing 'M-1x/90', column 3: '1x/90'" + alone("1x"));
  EXPECT_EQ(error_of("M-Y1/90+1x-Y1-2x"),
            "routing 'M-Y1/90+1x-Y1-2x', column 3: 'Y1/90'" + alone("Y1"));
  EXPECT_EQ(error_of("1/90-T-1"),
            "routing '1/90-T-1', column 8: the loop begins with '1/90' and comes back to '1': "
            "expected the same token");
}

}  // namespace
}  // namespace reeve::testing
