// Tendons that blocks and bars tie together: closed forms by hand, the values that two independent
// methods gave, and what holds in every state.
#include "core/tension/tree_tension.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/performance.hpp"
#include "core/tension/tension.hpp"
#include "tests/core/network_of.hpp"
#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

using std::exp;
using std::numbers::pi;

constexpr double rounding_error = 1e-12;

struct SolvedTree : testing::SolvedNetwork {
  explicit SolvedTree(const std::string& word, Grasp grasp = {}, const Hardware& hardware = {},
                      Direction direction = Direction::pull)
      : SolvedNetwork(testing::solved_network(word, hardware, grasp, direction)),
        performance(core::performance(network, state, direction)) {}

  Performance performance;
};

Hardware without_friction() {
  Hardware hardware;
  hardware.tube.mu = hardware.bearing.mu = hardware.sheath.mu = 0;
  return hardware;
}

Hardware without_sheath_friction(double bearing_exponent) {
  Hardware hardware = without_friction();
  hardware.bearing = {bearing_exponent / pi, pi};
  return hardware;
}

struct Printed {
  std::string word;
  double uniformity;
  double efficiency;
};

TEST(TreeTension, MatchesTR7WithASingleSheath) {
  for (const Printed& reference :
       {Printed{"1-P-2-P-1", 0.998, 0.322}, Printed{"M-Y1+1x-Y1-2x", 0.998, 0.322},
        Printed{"1x-P-2x", 0.998, 0.322}, Printed{"M-Y1+F-1b-Y1-2b-F", 0.995, 0.322},
        Printed{"M-Y1+F-1-Y1-2-F", 0.567, 0.253}}) {
    double uniformity = 0;
    double efficiency = 0;
    for (const Grasp& grasp : {Grasp{}, hold({1}), hold({2})}) {
      const SolvedTree s(reference.word, grasp);
      EXPECT_NEAR(s.performance.uniformity, reference.uniformity, 0.003) << reference.word;
      uniformity += s.performance.uniformity / 3;
      efficiency += s.performance.efficiency / 3;
    }
    EXPECT_NEAR(uniformity, reference.uniformity, 0.0005) << reference.word;
    EXPECT_NEAR(efficiency, reference.efficiency, 0.0005) << reference.word;
  }
}

TEST(TreeTension, OfATreeOfThreeBlocks) {
  const SolvedTree s("M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x", hold({1}));
  EXPECT_NEAR(s["a"], 1, rounding_error);
  EXPECT_NEAR(s["h1"], 0.3227, 5e-5);
  EXPECT_NEAR(s["T1"], 0.0809, 5e-5);
  EXPECT_NEAR(s["T3"], 0.0807, 5e-5);
  EXPECT_NEAR(s["T5"], 0.0806, 5e-5);
  EXPECT_NEAR(s["T7"], 0.0806, 5e-5);
}

TEST(TreeTension, OfALoopThroughABlock) {
  const SolvedTree s("M-1-Y1+2-Y1-3-T-2", hold({2}));
  const std::vector<double> expected{0.3227, 0.1833, 0.0522, 0.0918, 0.0915, 0.0520};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(s["T" + std::to_string(i + 1)], expected[i], 5e-5);
  }
  EXPECT_NEAR(s.performance.efficiency, 0.2165, 5e-5);
}

TEST(TreeTension, OfTacklesIsTheSumOfPowersOfTheSheavesLoss) {
  const double r = exp(-0.1);
  const Hardware hardware = without_sheath_friction(0.1);
  const auto load = [&](const char* word) { return SolvedTree(word, {}, hardware)["T1"]; };
  EXPECT_NEAR(load("M-B-1x"), r, rounding_error);
  EXPECT_NEAR(load("M-Y1-F+Y1-1x"), 1 + r, rounding_error);
  EXPECT_NEAR(load("M-B-Y1-F+Y1-1x"), r + r * r, rounding_error);
  EXPECT_NEAR(load("M-B-Y1-B-Y1k+Y1-1x"), r + r * r + std::pow(r, 3), rounding_error);
  EXPECT_NEAR(load("M-B-Y1-B-Y1-F+Y1-1x"), r + r * r + std::pow(r, 3) + std::pow(r, 4),
              rounding_error);
  EXPECT_NEAR(load("M-Y1-B-Y1k+Y1-1x"), 1 + r + r * r, rounding_error);
  // A haul on a haul: the second one's rope carries 1 + r + r².
  EXPECT_NEAR(load("M-Y2-B-Y2k+Y2-Y1-B-Y1k+Y1-1x"), std::pow(1 + r + r * r, 2), 1e-11);
}

// Tendons and blocks form a ring, and still each moves in one way only.
TEST(TreeTension, OfHaulsWhoseRopesShareABlock) {
  const double r = exp(-0.1);
  const Hardware hardware = without_sheath_friction(0.1);
  // Y2's two strands, 1 and r, pull the second rope, which passes Y1; the first rope's end, behind
  // another sheave, helps.
  EXPECT_NEAR(SolvedTree("M-Y2-B-Y1k+Y2-Y1-F+Y1-1x", {}, hardware)["T1"], (1 + r) * (1 + r) + r * r,
              1e-11);
  EXPECT_NEAR(SolvedTree("M-Y2-B-Y1k+Y2-Y1-F+Y1-1x", {}, without_friction())["T1"], 5, 1e-11);
  EXPECT_NEAR(SolvedTree("M-Y2-Y3k+Y2-Y1-Y3k+Y3-B-Y1k+Y1-1x", {}, without_friction())["T1"], 7,
              1e-11);
}

TEST(TreeTension, WithoutFrictionATackleHasItsIdealRatioAndLosesNoWork) {
  std::string strands;
  for (int parts = 2; parts <= 10; parts += 2) {
    strands += "-B-Y1";
    const SolvedTree s("M" + strands + "-F+Y1-1x", {}, without_friction());
    EXPECT_NEAR(s["T1"], parts, 1e-10);
    EXPECT_NEAR(s.state.closing[0], 1.0 / parts, rounding_error);
    EXPECT_NEAR(s.performance.efficiency, 1, 1e-10);
  }
}

TEST(TreeTension, ABlockMovesTowardsItsTail) {
  const SolvedTree pulled("M-Y1+1x-Y1-2x");
  EXPECT_NEAR(pulled.state.block_travel[0], 1, rounding_error);
  EXPECT_NEAR(pulled.state.closing[0], 1, rounding_error);
  const SolvedTree hauled("M-Y1-F+Y1-1x", {}, without_friction());
  EXPECT_NEAR(hauled.state.block_travel[0], -0.5, rounding_error);
  EXPECT_NEAR(hauled.state.closing[0], 0.5, rounding_error);
}

TEST(TreeTension, AHeldBranchIsAnAnchorAndNoJam) {
  const SolvedTree s("M-3-Y1+1x-Y1-2x", hold({1, 2}));
  EXPECT_FALSE(s.state.jams);
  EXPECT_EQ(s.state.block_travel[0], 0);
  EXPECT_NEAR(s.state.closing[2], 0.5, rounding_error);
  EXPECT_NEAR(s["T1"] + s["T3"], s["T6"], rounding_error);
  EXPECT_EQ(s.state.slip[2], 0);  // at the block
}

TEST(TreeTension, JamsWhereNoFingerCanGiveWay) {
  for (const char* word : {"M-Y1+1x-Y1-2x", "M-Y1+F-1-Y1-2-F", "M-W1+1x-W1-2x"}) {
    const SolvedTree s(word, hold({1, 2}));
    EXPECT_TRUE(s.state.jams) << word;
    EXPECT_EQ(s.performance.efficiency, 0) << word;
    EXPECT_NEAR(s["a"], 1, rounding_error) << word;
    EXPECT_EQ(s.state.block_travel[0], 0) << word;
  }
  // The block of both branches cannot follow: one of them is held.
  EXPECT_TRUE(SolvedTree("M-Y1+1x-Y1-2x+3x-Y1-4x", hold({3, 4})).state.jams);
  // Fingers on two tails of one block cannot close unlike.
  EXPECT_TRUE(SolvedTree("M-Y1-F+Y1-1x+Y1-2x", hold({1})).state.jams);
}

TEST(TreeTension, BranchesOfOneBlockCloseAsEvenlyAsTheyCan) {
  const SolvedTree s("M-Y1+1x-Y1-2x+3x-Y1-4x", hold({3}));
  EXPECT_FALSE(s.state.jams);
  EXPECT_NEAR(s.state.closing[0], 1, 1e-9);
  EXPECT_NEAR(s.state.closing[1], 1, 1e-9);
  EXPECT_NEAR(s.state.closing[3], 2, 1e-9);
}

// Finger 4 held: 2 z2 = dl3 and 2 = dl5 + z2 leave one freedom beside dl1 = dl2 = 1.
TEST(TreeTension, WhatTheConstraintsLeaveOpenHasTheLeastWeightedVariance) {
  const std::string word = "M-Y1+1x-Y1-2x+Y2-Y1-5x+3x-Y2-4x";
  const SolvedTree alike(word, hold({4}));
  EXPECT_NEAR(alike.state.closing[2], 24.0 / 19, rounding_error);
  EXPECT_NEAR(alike.state.closing[4], 26.0 / 19, rounding_error);
  Hardware hardware;
  hardware.fingers.push_back({5, {}, {}, {}, {}, {}, 2});
  const SolvedTree weighed(word, hold({4}), hardware);
  EXPECT_NEAR(weighed.state.closing[2], 36.0 / 43, rounding_error);
  EXPECT_NEAR(weighed.state.closing[4], 68.0 / 43, rounding_error);
}

TEST(TreeTension, OfATreeThatJamsBesideAnotherTakesAll) {
  const SolvedTree s("M-Y1+1x-Y1-2x+M-Y2+3x-Y2-4x", hold({1, 2}));
  EXPECT_TRUE(s.state.jams);
  EXPECT_EQ(s["a"], 1);
  EXPECT_EQ(s["T5"], 0);
}

// The motor on the tail pulls the block down, that on the third tendon pulls it up by as much.
TEST(TreeTension, OfATendonThatTheOthersSlackenIsNone) {
  for (const char* word : {"M-Y1+1x-Y1-2x+M-Y1-3x", "M-Y1-3x+M-Y1+1x-Y1-2x"}) {
    const SolvedTree s(word, hold({1, 2, 3}));
    EXPECT_EQ(s["T1"], 0) << word;
    EXPECT_EQ(s["T3"], 0) << word;
    EXPECT_GT(s["T5"], 0.1) << word;
  }
}

TEST(TreeTension, ABarSharesByItsArmsWhateverIsHeld) {
  for (const Grasp& grasp : {Grasp{}, hold({1}), hold({2})}) {
    const SolvedTree s("M-W1+1x-W1/2:1-2x", grasp);
    const double pivot = exp(-0.36 * pi);
    EXPECT_NEAR(s["T1"], pivot * 2 / 3, rounding_error);
    EXPECT_NEAR(s["T3"], pivot / 3, rounding_error);
  }
  // Its pivot moves by (2 z_l + z_r) / 3.
  EXPECT_NEAR(SolvedTree("M-W1+1x-W1/2:1-2x", hold({2})).state.closing[0], 1.5, rounding_error);
  EXPECT_NEAR(SolvedTree("M-W1+1x-W1/2:1-2x", hold({1})).state.closing[1], 3, rounding_error);
}

TEST(TreeTension, BarsInARowMultiplyTheirRatios) {
  // W2's pivot hangs on the right arm of W1: T1 : (T3 + T5) = 1 : 2 and T3 : T5 = 3 : 1.
  const SolvedTree s("M-W1+1x-W1/1:2-W2+2x-W2/3:1-3x", {}, without_friction());
  EXPECT_NEAR(s["T1"], 1.0 / 3, rounding_error);
  EXPECT_NEAR(s["T3"], 0.5, rounding_error);
  EXPECT_NEAR(s["T5"], 1.0 / 6, rounding_error);
  EXPECT_NEAR(s.performance.efficiency, 1, rounding_error);
}

TEST(TreeTension, ABarInsideATendonLosesNoWork) {
  for (const Grasp& grasp : {Grasp{}, hold({1}), hold({2}), hold({3})}) {
    const SolvedTree s("M-W1+1x-B-W1/2:5-2-T-3-F", grasp, without_friction());
    EXPECT_NEAR(s["T1"] / s["T3"], 0.4, rounding_error);
    EXPECT_NEAR(s.performance.efficiency, 1, rounding_error);
  }
}

TEST(TreeTension, ABlocksBearingMayHaveItsOwnLaw) {
  Hardware hardware = without_sheath_friction(0.1);
  hardware.block = ContactLaw{0.3 / pi, pi};
  const double r = exp(-0.1);
  const double block = exp(-0.3);
  EXPECT_NEAR(SolvedTree("M-B-Y1-B-Y1k+Y1-1x", {}, hardware)["T1"], r + r * block + r * r * block,
              rounding_error);
  hardware.contacts = {{"h1", "h2", {}, {}}, {"h2", "h3", 0.0, {}}};
  EXPECT_NEAR(SolvedTree("M-B-Y1-B-Y1k+Y1-1x", {}, hardware)["T1"], r + r + r * r, rounding_error);
}

TEST(TreeTension, ReleasedTheMotorGetsWhatFrictionLeaves) {
  const double r = exp(-0.1);
  const SolvedTree s("M-Y1-B-Y1k+Y1-1x", {}, without_sheath_friction(0.1), Direction::release);
  EXPECT_NEAR(s["T1"], 1 + 1 / r + 1 / (r * r), 1e-11);
  EXPECT_NEAR(s.state.block_travel[0], -1.0 / 3, rounding_error);
}

TEST(TreeTension, SeveralTreesShareTheCarriageByTheirStiffness) {
  const SolvedTree s("M-Y1+1x-Y1-2x+M-Y2+3x-Y2-4x", {}, without_friction());
  for (const char* segment : {"a", "b"}) EXPECT_NEAR(s[segment], 0.5, rounding_error);
  const SolvedTree unlike("M-Y1+1x-Y1-2x+M-3x", {}, without_friction());
  // Of each, the work of a unit of motor tension on the stretch of its segments, all as long: in
  // the tree 1² + 1² + (1/2)² + (1/2)², in the single tendon 1² + 1².
  EXPECT_NEAR(unlike["a"] / unlike["b"], 2.0 / 2.5, rounding_error);
}

TEST(TreeTension, BlocksThatAreFreeAgainstEachOtherAreRefused) {
  EXPECT_NE(testing::out_of_range([] {
              SolvedTree("Y1-P-Y2+1x-Y1-T-Y2-2x");
            }).find("blocks are free to move against each other"),
            std::string::npos);
}

}  // namespace
}  // namespace reeve
