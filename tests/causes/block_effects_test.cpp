// Effects of a rig on floating blocks and bars, by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/causes/rig.hpp"

namespace reeve {
namespace {

using testing::effect;
using testing::model_with;
using testing::solved;

constexpr double rounding_of_model = 1e-8;

Hardware frictionless_hardware() {
  Hardware hardware;
  hardware.tube.mu = hardware.bearing.mu = hardware.sheath.mu = 0;
  return hardware;
}

// a, then F less behind each of two sheaves: the load is 3a − 3F.
TEST(BearingDrag, TakesItsForceAtABlocksSheaveToo) {
  Model model = model_with({effect("bearing_drag", {0.5})}, frictionless_hardware());
  model.conditions.motor_tension_N = 20;
  const auto s = solved(model, "M-Y1-B-Y1k+Y1-1x");
  EXPECT_NEAR(20 * s["T1"], 20 + 19.5 + 19, 20 * rounding_of_model);
  EXPECT_TRUE(s.converged);
}

TEST(BearingFriction, IsThatOfABlockWithoutALawOfItsOwn) {
  const double r = std::exp(-0.05 * std::numbers::pi);
  const auto load = [](const Hardware& hardware) {
    return solved(model_with({effect("bearing_friction", {0.05})}, hardware), "M-Y1-F+Y1-1x")["T1"];
  };
  Hardware hardware = frictionless_hardware();
  hardware.sheath.mu = 0;
  EXPECT_NEAR(load(hardware), 1 + r, rounding_of_model);
  hardware.block = ContactLaw{0, std::numbers::pi};
  EXPECT_NEAR(load(hardware), 2, rounding_of_model);
}

TEST(LoadDependentFriction, SparesBlocksAndActsOnTheSheathAboveThem) {
  Hardware hardware;
  hardware.bearing.mu = 0;
  Model model = model_with({effect("load_dependent_friction", {0.2})}, hardware);
  model.conditions.motor_tension_N = 40;
  const double tail = std::exp(-0.36 * std::numbers::pi * std::pow(4, -0.2));
  const auto s = solved(model, "M-Y1+1x-Y1-2x", hold({1}));
  EXPECT_NEAR(s["T1"], tail / 2, rounding_of_model);
  EXPECT_NEAR(s["T3"], tail / 2, rounding_of_model);
}

TEST(SheathAngle, OfAFingerLeavesSheathsThatLeadToABlock) {
  Subject finger;
  finger.finger = 1;
  const double nominal = std::exp(-0.36 * std::numbers::pi);
  const auto at = [&](const char* word, const char* segment) {
    return solved(model_with({effect("sheath_angle", {1}, finger)}), word)[segment];
  };
  EXPECT_NEAR(at("M-Y1+1x-Y1-2x", "h1"), nominal, rounding_of_model);
  EXPECT_NEAR(at("M-1x", "T1"), nominal * std::exp(-0.18), rounding_of_model);
}

// The tendon ends at the block on both sides: each finger follows it as far as it moves.
TEST(SeizedContact, OnABlockTiesBothStrandsToIt) {
  Subject sheave;
  sheave.routing = "M-Y1+1x-Y1-2x";
  sheave.contact = "T1-T3";
  const Model model = model_with({effect("seized_contact", {}, sheave)});
  const auto free = solved(model, sheave.routing);
  EXPECT_NEAR(free.state.closing[0], 1, rounding_of_model);
  EXPECT_NEAR(free.state.closing[1], 1, rounding_of_model);
  EXPECT_NEAR(free["T1"], free["h1"] / 2, rounding_of_model);
  // With one of them held neither can move, where a sheave that turns lets the other close.
  EXPECT_TRUE(solved(model, sheave.routing, hold({1})).state.jams);
  EXPECT_FALSE(solved(model_with({}), sheave.routing, hold({1})).state.jams);
}

TEST(SeizedContact, OfABarKeepsItFromTurning) {
  Subject bar;
  bar.routing = "M-W1+1x-W1/2:1-2x";
  bar.contact = "T1-T3";
  const auto s = solved(model_with({effect("seized_contact", {}, bar)}), bar.routing);
  EXPECT_NEAR(s.state.closing[0], s.state.closing[1], rounding_of_model);
  EXPECT_NEAR(s["T1"] + s["T3"], s["h1"], rounding_of_model);
  EXPECT_NEAR(s["T1"], s["T3"], rounding_of_model);
}

// Above the block the tendon ends in the seized sheath: the hand side is let go.
TEST(SeizedContact, InTheSheathAboveABlockLeavesItsBranchSlack) {
  Subject sheath;
  sheath.routing = "M-Y1+1x-Y1-2x";
  sheath.contact = "a-h1";
  const auto s = solved(model_with({effect("seized_contact", {}, sheath)}), sheath.routing);
  EXPECT_TRUE(s.state.jams);
  EXPECT_NEAR(s["a"], 1, rounding_of_model);
  EXPECT_EQ(s["T1"], 0);
}

}  // namespace
}  // namespace reeve
