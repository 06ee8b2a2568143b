// What hands of random routings owe to physics.
#include "core/hand.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "core/hand_closing.hpp"
#include "studies/shown_hand.hpp"
#include "tests/support/example_hand.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using testing::Dice;
using testing::Trial;

FingerParts random_finger(Dice& dice) {
  FingerParts parts;
  parts.force_N = dice.real(0, 20);
  for (int j = dice.integer(1, 3); j > 0; --j) {
    FingerJoint joint{dice.real(3, 15), dice.real(20, 110), dice.real(10, 100)};
    if (dice.chance(0.5)) joint.spring_Nmm_rad = dice.real(0, 50);
    joint.rest_deg = dice.real(-40, 10);
    if (dice.chance(0.5)) joint.held_deg = dice.real(0, joint.range_deg);
    parts.joints.push_back(joint);
  }
  return parts;
}

// The trial's hardware with a hand: common parts, and fingers with parts of their own.
Hardware with_hand(const Trial& trial) {
  Dice dice(trial.seed + 1'000'000);
  Hardware hardware = trial.hardware;
  hardware.finger_parts = random_finger(dice);
  for (FingerHardware& finger : hardware.fingers) {
    if (dice.chance(0.7)) finger.parts = random_finger(dice);
  }
  return hardware;
}

using HandCheck = std::function<void(const Trial& trial, const Hardware& hardware)>;

void for_each_hand(const HandCheck& check) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const Trial trial = testing::random_trial(seed, {1, 6, true, true});
    SCOPED_TRACE(testing::to_text(trial));
    check(trial, with_hand(trial));
    if (::testing::Test::HasFailure()) return;
  }
}

// What the fingers of a tendon give up, for each motor-side segment that takes it.
double travel_of(const Network& network, const TendonSpan& tendon, const Hand& hand) {
  double given = 0;
  double motor_sides = 0;
  for (std::size_t i = 0; i < tendon.segments; ++i) {
    const Segment& segment = network.segments[tendon.first_segment + i];
    if (segment.kind == SegmentKind::strand) given += hand.finger(segment.finger).excursion_mm;
    if (segment.kind == SegmentKind::motor_side) motor_sides += 1;
  }
  return given / motor_sides;
}

TEST(HandOfARandomRouting, ClosesUntilTheTendonWithLeastToGiveBlocksTheCarriage) {
  for_each_hand([](const Trial& trial, const Hardware& hardware) {
    const Network& network = trial.network;
    const Hand known = *hand(hardware);
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    for (const TendonSpan& tendon : network.tendons) {
      least = std::min(least, travel_of(network, tendon, known));
      most = std::max(most, travel_of(network, tendon, known));
    }
    Kinematics kinematics;
    Motion motion;
    const HandClosing closing =
        close_hand(known, network, mechanics(network, hardware), kinematics, motion);
    EXPECT_NEAR(closing.stroke_mm, least, 1e-8);
    EXPECT_NEAR(closing.closure, least / most, 1e-8);
  });
}

double friction_work(const Network& network, const TensionState& state) {
  double work = 0;
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const auto [left, right] = ends_of(tendon, k);
      const double drop = state.tension[left] - state.tension[right];
      work += std::abs(drop * state.slip[tendon.first_contact + k]);
    }
  }
  return work;
}

// Motor work = springs + friction at the contacts + work that the fingers do.
TEST(HandOfARandomRouting, BalancesTheWorkOfTheMotor) {
  int balanced = 0;
  for_each_hand([&](const Trial& trial, const Hardware& hardware) {
    const auto shown = studies::shown_hand(trial.network, "", Model{hardware}, {{Grasp{}, 1}});
    ASSERT_TRUE(shown);
    const MotorDemand& demand = shown->demand;
    const TensionState state = tensions(trial.network, mechanics(trial.network, hardware), Grasp{});
    if (!std::isfinite(demand.force_N) || state.jams) return;
    ++balanced;
    const double friction =
        demand.force_N * demand.stroke_mm / 1000 * friction_work(trial.network, state);
    const double scale = 1e-9 * std::max(1.0, demand.work_J);
    EXPECT_NEAR(demand.friction_J, friction, scale);
    EXPECT_NEAR(demand.work_J, demand.springs_J + demand.friction_J + demand.fingers_J, scale);
    EXPECT_GE(demand.fingers_J, -scale);  // they close against their springs, at least
  });
  EXPECT_GT(balanced, 500);
}

TEST(HandOfARandomRouting, MeetsEveryWantedForceAtTheMotorForceAndNotBelowIt) {
  int told = 0;
  for_each_hand([&](const Trial& trial, const Hardware& hardware) {
    const Hand known = *hand(hardware);
    const Mechanics parts = mechanics(trial.network, hardware);
    const TensionState state = tensions(trial.network, parts, trial.grasp);
    const GripDemand demand =
        grip_demand(known, trial.network.fingers,
                    testing::pulls_in(trial.network, parts, trial.grasp), trial.grasp);
    if (!std::isfinite(demand.motor_force_N) || demand.motor_force_N == 0) return;
    const FingerArray pulls = pulls_by_finger(trial.network, state);
    for (int f = 1; f <= trial.network.fingers; ++f) {
      const double pull = demand.motor_force_N * pulls[static_cast<std::size_t>(f)];
      EXPECT_GE(held_force(known.finger(f), {1}, pull).force_N,
                known.finger(f).force_N * (1 - 1e-9));
    }
    const HandFinger& weakest = known.finger(demand.weakest);
    const bool by_grip = trial.grasp.holds(demand.weakest) ||
                         motor_force(weakest, true, {1}) >= motor_force(weakest, false, {1});
    if (!by_grip || weakest.force_N == 0) return;
    ++told;
    const double pull =
        0.999 * demand.motor_force_N * pulls[static_cast<std::size_t>(demand.weakest)];
    EXPECT_LT(held_force(weakest, {1}, pull).force_N, weakest.force_N);
  });
  EXPECT_GT(told, 500);
}

// One tendon without friction has one tension, and all motor-side segments pull with it.
TEST(HandOfARandomRouting, IsComparedWithOneTensionAlongATendonWithoutFriction) {
  int compared = 0;
  for_each_hand([&](const Trial& trial, const Hardware& hardware) {
    const Network& network = trial.network;
    if (network.tendons.size() > 1) return;
    ++compared;
    const auto shown = studies::shown_hand(network, "", Model{hardware}, {{trial.grasp, 1}});
    ASSERT_TRUE(shown);
    const auto motor_sides = std::count_if(
        network.segments.begin(), network.segments.end(),
        [](const Segment& segment) { return segment.kind == SegmentKind::motor_side; });
    double most = 0;
    for (int f = 1; f <= network.fingers; ++f) {
      const double pull = 2.0 / static_cast<double>(motor_sides);
      most = std::max(most, motor_force(hand(hardware)->finger(f), trial.grasp.holds(f), {pull}));
    }
    EXPECT_NEAR(shown->grasps[0].frictionless_N, most, 1e-9 * std::max(1.0, most));
  });
  EXPECT_GT(compared, 200);
}

}  // namespace
}  // namespace reeve
