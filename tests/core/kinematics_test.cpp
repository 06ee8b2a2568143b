#include "core/tension/kinematics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using Values = std::vector<double>;

Motion motion(const Network& network, const Mechanics& mechanics, Grasp grasp,
              Direction direction = Direction::pull) {
  Motion result;
  Kinematics().solve(network, mechanics, grasp, direction, result);
  return result;
}

Motion motion(const std::string& word, Grasp grasp, Direction direction = Direction::pull,
              const Hardware& hardware = {}) {
  const Network network = expand(parse_routing(word));
  return motion(network, mechanics(network, hardware), grasp, direction);
}

FingerHardware closing(int number, double weight) {
  FingerHardware finger;
  finger.finger = number;
  finger.closing = weight;
  return finger;
}

// ---- what is imposed ----

TEST(Kinematics, ClosingFingersShareTheTravelOfAllMotorSides) {
  EXPECT_EQ(motion("M-1-T-2-F", Grasp{}).closing, (Values{0.25, 0.25}));
  EXPECT_EQ(motion("M-1-T-2-M", Grasp{}).closing, (Values{0.5, 0.5}));
  EXPECT_EQ(motion("1-P-2-P-1", Grasp{}).closing, (Values{1, 1}));
}

TEST(Kinematics, AHeldFingerLeavesItsShareToTheOthers) {
  EXPECT_EQ(motion("M-1-T-2-F", hold({1})).closing, (Values{0, 0.5}));
  EXPECT_EQ(motion("1-P-2-P-1", hold({2})).closing, (Values{2, 0}));
}

TEST(Kinematics, ClosingWeightsShareTheTravel) {
  Hardware hardware;
  hardware.fingers = {closing(1, 1), closing(2, 4)};
  EXPECT_EQ(motion("M-1-T-2-F", Grasp{}, Direction::pull, hardware).closing, (Values{0.1, 0.4}));
}

TEST(Kinematics, EachTendonSharesItsOwnTravel) {
  EXPECT_EQ(motion("M-1-F+2-P-3-T-2", Grasp{}).closing, (Values{0.5, 0.5, 0.5}));
  EXPECT_EQ(motion("M-1-F+M-2-B-3-F", hold({2})).closing, (Values{0.5, 0, 0.5}));
}

TEST(Kinematics, PullingGivesMotorSidesTravelAndTakesItFromTheFingers) {
  const Motion pulled = motion("M-1-T-2-F", hold({1}));
  EXPECT_EQ(pulled.imposed, (Values{1, 0, 0, -0.5, -0.5}));
  EXPECT_EQ(pulled.take_up, (Values{0, 0, 0, 0.5, 0.5}));
  EXPECT_EQ(pulled.slip, (Values{-1, -1, -1, -0.5}));
  EXPECT_EQ(pulled.jams, std::vector<char>{0});
}

TEST(Kinematics, ReleasingReversesTravelAndSlipAndTheCarriageYields) {
  const Motion released = motion("M-1-T-2-F", hold({1}), Direction::release);
  EXPECT_EQ(released.imposed, (Values{-1, 0, 0, 0.5, 0.5}));
  EXPECT_EQ(released.take_up, (Values{1, 0, 0, 0, 0}));
  EXPECT_EQ(released.slip, (Values{1, 1, 1, 0.5}));
  EXPECT_EQ(released.closing, (Values{0, 0.5}));
}

TEST(Kinematics, WhatDoesNotMoveHasExactlyNoSlip) {
  // TR2 with finger 1 held: "the tendon between segments 3 and 4 does not move".
  EXPECT_EQ(motion("M-1-T-2-M", hold({1})).slip, (Values{-1, -1, -1, 0, 1}));
}

TEST(Kinematics, RoundingIsNoSlip) {
  // A held finger behind fingers whose shares do not add up exactly in binary.
  Hardware uneven;
  for (int f = 1; f <= 3; ++f) uneven.fingers.push_back(closing(f, 0.1 * f));
  const Motion moved = motion("M-1-T-2-T-3-T-4-F", hold({4}), Direction::pull, uneven);
  EXPECT_EQ(moved.slip[6], 0);  // T6 to T7
  EXPECT_EQ(moved.slip[7], 0);  // round the tip of finger 4
}

// ---- jam ----

TEST(Kinematics, AJamPullsTheMotorSidesAndMovesNothing) {
  const Motion jammed = motion("M-1-F", hold({1}));
  EXPECT_EQ(jammed.jams, std::vector<char>{1});
  EXPECT_EQ(jammed.imposed, (Values{0, 0, 0}));
  EXPECT_EQ(jammed.take_up, (Values{1, 0, 0}));
  EXPECT_EQ(jammed.slip, (Values{0, 0}));
  EXPECT_EQ(jammed.closing, Values{0});
}

// Each segment as much as it is long: one strain.
TEST(Kinematics, AJamInReleaseLeavesTheHandSideStretched) {
  EXPECT_EQ(motion("M-1-F", hold({1}), Direction::release).take_up, (Values{0, 100, 100}));
  EXPECT_EQ(motion("M-T-F", Grasp{}, Direction::release).take_up, (Values{0, 100, 100}));
}

TEST(Kinematics, OneJammedTendonBlocksTheCarriageForAll) {
  const Motion jammed = motion("M-1-F+M-2-F", hold({2}));
  EXPECT_EQ(jammed.jams, (std::vector<char>{0, 1}));
  EXPECT_EQ(jammed.slip, (Values{0, 0, 0, 0}));
  EXPECT_EQ(jammed.closing, (Values{0, 0}));
}

TEST(Kinematics, ATendonWithoutFingersAlwaysJams) {
  EXPECT_EQ(motion("M-F", Grasp{}).jams, std::vector<char>{1});
  EXPECT_EQ(motion("M-T-P-M", Grasp{}).jams, std::vector<char>{1});
}

// ---- loops ----

double friction_loss(const TendonSpan& tendon, const Mechanics& mechanics, const Values& slip) {
  double loss = 0;
  for (std::size_t k = tendon.first_contact; k < tendon.first_contact + tendon.contacts; ++k) {
    loss += mechanics.phi[k] * std::abs(slip[k]);
  }
  return loss;
}

// Σ phi |s + c| is least at a breakpoint: try them all.
double least_friction_loss(const TendonSpan& tendon, const Mechanics& mechanics,
                           const Values& slip) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = tendon.first_contact; k < tendon.first_contact + tendon.contacts; ++k) {
    Values turned = slip;
    for (double& s : turned) s -= slip[k];
    least = std::min(least, friction_loss(tendon, mechanics, turned));
  }
  return least;
}

bool has_a_still_contact(const TendonSpan& tendon, const Values& slip) {
  const auto first = slip.begin() + static_cast<std::ptrdiff_t>(tendon.first_contact);
  return std::count(first, first + static_cast<std::ptrdiff_t>(tendon.contacts), 0.0) > 0;
}

TEST(Kinematics, ALoopTurnsSoThatSlipCostsLeast) {
  int loops = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const testing::Trial trial = testing::random_trial(seed);
    SCOPED_TRACE(testing::to_text(trial));
    const Mechanics m = mechanics(trial.network, trial.hardware);
    const Motion moved = motion(trial.network, m, trial.grasp, trial.direction);
    for (const TendonSpan& tendon : trial.network.tendons) {
      if (!tendon.closed) continue;
      ++loops;
      const double least = least_friction_loss(tendon, m, moved.slip);
      EXPECT_NEAR(friction_loss(tendon, m, moved.slip), least, 1e-9 * (1 + least));
      EXPECT_TRUE(has_a_still_contact(tendon, moved.slip));
    }
  }
  EXPECT_GT(loops, 300);
}

TEST(Kinematics, ALoopTurnsAboutTheContactWithTheMostFriction) {
  Hardware hardware;
  hardware.tube.mu = hardware.bearing.mu = hardware.sheath.mu = 0.01;
  hardware.contacts = {{"T4", "a", 3.0, 1.0}};
  // T2 |join| T3 |tip| T4 |sheath| a |pulley| b |sheath| T1 |tip| T2: the sheath at T4 stands.
  const Motion moved = motion("1-T-2-P-1", hold({1}), Direction::pull, hardware);
  EXPECT_EQ(moved.slip, (Values{-2, -1, 0, -1, -2, -2}));
}

// ---- conservation ----

void expect_conserved(const Network& network, const TendonSpan& tendon, const Motion& moved) {
  for (std::size_t i = 0; i < tendon.segments; ++i) {
    const bool is_last = !tendon.closed && i + 1 == tendon.segments;
    const bool is_first = !tendon.closed && i == 0;
    const std::size_t before = i == 0 ? tendon.contacts - 1 : i - 1;
    const double out = is_last ? 0 : moved.slip[tendon.first_contact + i];
    const double in = is_first ? 0 : moved.slip[tendon.first_contact + before];
    EXPECT_NEAR(moved.imposed[tendon.first_segment + i] + out - in, 0, 1e-9)
        << segment_name(network.segments[tendon.first_segment + i]);
  }
}

TEST(Kinematics, NoTendonIsMadeOrLostAnywhere) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const testing::Trial trial = testing::random_trial(seed);
    SCOPED_TRACE(testing::to_text(trial));
    const Motion moved = motion(trial.network, mechanics(trial.network, trial.hardware),
                                trial.grasp, trial.direction);
    if (std::count(moved.jams.begin(), moved.jams.end(), 1) > 0) continue;
    for (const TendonSpan& tendon : trial.network.tendons) {
      expect_conserved(trial.network, tendon, moved);
    }
  }
}

TEST(Kinematics, ATendonTakesUpAsMuchAsItsMotorSidesTravel) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const testing::Trial trial = testing::random_trial(seed);
    SCOPED_TRACE(testing::to_text(trial));
    const Motion moved = motion(trial.network, mechanics(trial.network, trial.hardware),
                                trial.grasp, trial.direction);
    for (std::size_t t = 0; t < trial.network.tendons.size(); ++t) {
      if (moved.jams[t] != 0) continue;
      const TendonSpan& tendon = trial.network.tendons[t];
      double take_up = 0;
      double motor_sides = 0;
      for (std::size_t i = 0; i < tendon.segments; ++i) {
        take_up += moved.take_up[tendon.first_segment + i];
        motor_sides +=
            trial.network.segments[tendon.first_segment + i].kind == SegmentKind::motor_side;
      }
      EXPECT_NEAR(take_up, motor_sides, 1e-9);
    }
  }
}

TEST(Kinematics, SlideFollowsTheSignOfTheSlip) {
  EXPECT_EQ(slide_of(0.1), Slide::to_right);
  EXPECT_EQ(slide_of(-0.1), Slide::to_left);
  EXPECT_EQ(slide_of(0), Slide::no);
}

}  // namespace
}  // namespace reeve
