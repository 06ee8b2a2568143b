// Tests the grasps in which a routing jams: small cases by hand. tests/property compares with the
// solver.
#include "core/tension/jamming.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "core/tension/seizure.hpp"

namespace reeve {
namespace {

struct Jams {
  double grasps = 0;
  std::vector<std::vector<int>> smallest;

  friend bool operator==(const Jams&, const Jams&) = default;
};

Jams jams_of(const Network& network, const Hardware& hardware = {}) {
  const Mechanics numbers = mechanics(network, hardware);
  JamFinder finder;
  Jams jams{finder.grasps(network, numbers), {}};
  for (const Grasp& grasp : finder.smallest(network, numbers)) {
    jams.smallest.push_back(held_fingers(grasp));
  }
  return jams;
}

Jams jams_of(const std::string& word) { return jams_of(expand(parse_routing(word))); }

TEST(Jamming, OneTendonThroughAllFingersNeverJams) {
  EXPECT_EQ(jams_of("1-P-2-P-1"), (Jams{0, {}}));
  EXPECT_EQ(jams_of("M-1-T-2-T-3-F"), (Jams{0, {}}));
}

TEST(Jamming, ATendonOfItsOwnJamsWhereItsFingersAreHeld) {
  EXPECT_EQ(jams_of("M-1-F+M-2-F"), (Jams{2, {{1}, {2}}}));
  EXPECT_EQ(jams_of("M-1-F+M-2-T-3-F"), (Jams{4, {{1}, {2, 3}}}));
  EXPECT_EQ(jams_of("1-P-2-P-1+3-P-4-P-3"), (Jams{6, {{1, 2}, {3, 4}}}));
}

TEST(Jamming, FingersOfABlockShareItsMotionSoThatOneHeldIsNoJam) {
  EXPECT_EQ(jams_of("M-Y1+1x-Y1-2x"), (Jams{0, {}}));
  EXPECT_EQ(jams_of("M-Y1+1x-Y1-2x+M-3-F"), (Jams{4, {{3}, {1, 2}}}));
}

TEST(Jamming, ATendonWithoutAFingerJamsInEveryGrasp) {
  EXPECT_EQ(jams_of("M-F+M-1-T-2-F"), (Jams{3, {{}}}));
  EXPECT_EQ(jams_of("M-F"), (Jams{0, {}}));
}

TEST(Jamming, ATendonThatItsSlackLeavesWithoutTensionStopsNothing) {
  Hardware hardware;
  hardware.tendon.travel_mm = 50;
  const auto jams_with_slack = [&](double slack_mm) {
    hardware.tendon.own = {{.tendon = 1, .slack_mm = slack_mm}};
    return jams_of(expand(parse_routing("1x-M+2x-M")), hardware);
  };
  EXPECT_EQ(jams_with_slack(49), (Jams{2, {{1}, {2}}}));
  EXPECT_EQ(jams_with_slack(50), (Jams{1, {{2}}}));
}

TEST(Jamming, ASeizedTipTiesEachSideToItsOwnFingers) {
  // One half of the tendon has a strand of finger 1 alone, the other strands of both fingers.
  const Network network = expand(parse_routing("M-1-T-2-M"));
  const std::size_t tip = *find_contact(network, "T1-T2");
  const Jams jams = jams_of(seize(network, {tip}).network);
  EXPECT_EQ(jams, (Jams{1, {{1}}}));
}

TEST(Jamming, OfManyFingersTheGraspsAreCountedAllTheSame) {
  std::string word = "M-1-F";
  for (int f = 2; f <= 20; ++f) word += "+M-" + std::to_string(f) + "-F";
  EXPECT_EQ(jams_of(word).grasps, std::ldexp(1.0, 20) - 2);
}

}  // namespace
}  // namespace reeve
