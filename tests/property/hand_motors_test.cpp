// Hands of several motors, against hands of one motor and against a search for the least force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/hand.hpp"
#include "core/motor_sides.hpp"
#include "core/notation.hpp"
#include "search/uncertainty/motor_force.hpp"
#include "studies/shown_hand.hpp"
#include "tests/support/example_hand.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using testing::Dice;

FingerParts finger_that_presses(Dice& dice) {
  FingerParts parts;
  parts.force_N = dice.real(1, 20);
  for (int j = dice.integer(1, 3); j > 0; --j) {
    FingerJoint joint{dice.real(3, 15), dice.real(20, 110), dice.real(10, 100)};
    if (dice.chance(0.5)) joint.spring_Nmm_rad = dice.real(0, 50);
    parts.joints.push_back(joint);
  }
  return parts;
}

Hardware random_hand(Dice& dice, int fingers) {
  std::vector<FingerParts> parts;
  for (int f = 0; f < fingers; ++f) parts.push_back(finger_that_presses(dice));
  return testing::hand_of(parts);
}

MotorForce need_of(const std::string& word, const Hardware& hardware, const GraspSet& grasps) {
  UncertaintyOptions options{Model{hardware}, {}, grasps, {}};
  options.draws = 1;
  return *search::motor_force(parse_routing(word), options);
}

void expect_alike(double a, double b) {
  if (std::isfinite(a) || std::isfinite(b)) {
    EXPECT_NEAR(a, b, 1e-7 * std::max(1.0, std::abs(b)));
  } else {
    EXPECT_EQ(a, b);
  }
}

// A routing without blocks, its fingers numbered on from `before` and pulled by another motor.
std::string moved_on(const Routing& routing, int before) {
  Routing moved = routing;
  for (Tendon& tendon : moved.tendons) {
    for (Token& token : tendon.walk) {
      if (is_of_finger(token.kind)) {
        token.finger = static_cast<std::uint8_t>(token.finger + before);
      }
      const bool is_on_carriage =
          token.kind == TokenKind::motor_end || token.kind == TokenKind::movable_pulley;
      if (is_on_carriage) token.carriage = 2;
    }
  }
  return to_word(moved);
}

TEST(HandOfTwoGroups, HasOfEachMotorTheForceAndStrokeOfThatHandAlone) {
  int finite = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Dice dice(seed);
    const Routing first = testing::random_routing(dice, {1, 3, true, true});
    const Routing second = testing::random_routing(dice, {1, 3, true, true});
    const int n = finger_count(first);
    const int m = finger_count(second);
    const Hardware both = random_hand(dice, n + m);
    Hardware other = both;
    other.fingers.erase(other.fingers.begin(), other.fingers.begin() + n);
    for (FingerHardware& finger : other.fingers) finger.finger -= n;
    const std::string word = to_word(first) + "+" + moved_on(second, n);
    SCOPED_TRACE(std::to_string(seed) + ": " + word);
    // Each hand is held as it is in the grasps of both.
    GraspSet of_first;
    GraspSet of_second;
    const GraspSet grasps = single_grasps(n + m);
    for (const WeightedGrasp& grasp : grasps) {
      const std::uint64_t held = grasp.grasp.held;
      of_first.push_back({Grasp{held & ((std::uint64_t{1} << n) - 1), {}, 0}, 1});
      of_second.push_back({Grasp{held >> n, {}, 0}, 1});
    }
    const MotorForce need = need_of(word, both, grasps);
    const MotorForce alone = need_of(to_word(first), both, of_first);
    const MotorForce other_alone = need_of(to_word(second), other, of_second);
    ASSERT_EQ(need.motors.size(), 2U);
    expect_alike(need.motors[0].force_N, alone.nominal_N);
    expect_alike(need.motors[1].force_N, other_alone.nominal_N);
    expect_alike(need.motors[0].stroke_mm, alone.stroke_mm);
    expect_alike(need.motors[1].stroke_mm, other_alone.stroke_mm);
    expect_alike(need.nominal_N, std::max(alone.nominal_N, other_alone.nominal_N));
    EXPECT_NEAR(need.closure, std::min(alone.closure, other_alone.closure), 1e-9);
    finite += std::isfinite(need.nominal_N) ? 1 : 0;
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(finite, 50);
}

// Whether the fingers reach their wanted forces at a sum of the motors' tensions.
bool reaches_all(const Hand& hand, const Network& network, const FingerPullArray& pulls,
                 const Grasp& grasp, double sum_N) {
  for (int f = 1; f <= network.fingers; ++f) {
    const FingerPull& pull = pulls[static_cast<std::size_t>(f)];
    const HandFinger& finger = hand.finger(f);
    if (held_force(finger, pull, sum_N).force_N < finger.force_N) return false;
    if (!grasp.holds(f) && !closes_springs(finger, pull, sum_N)) return false;
  }
  return true;
}

// Motors whose tendons hang together: by bisection of the sum of their tensions.
TEST(HandOfJoinedMotors, NeedsOfEachMotorItsPartOfTheLeastSumThatIsEnough) {
  const std::vector<std::string> words{
      "M-1-M2",         "M-1-B-2-M2",        "M-1-P2-2-F",       "1-P-2-P2-1",
      "M-1-T-2-B-3-M2", "M-1-P2-2-P3-3-M",   "M2-Y1+F-1-Y1-2-M", "M-Y1+1x-Y1-2-M2",
      "M-1-M2+M-2-M2",  "M-1-P-2-M2+M2-3-F", "M-1-M+M-2b-M2"};
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Dice dice(seed);
    const Network network =
        expand(parse_routing(words[static_cast<std::size_t>(dice.integer(0, 10))]));
    const Hardware hardware = random_hand(dice, network.fingers);
    const Hand known = *hand(hardware);
    const Mechanics parts = mechanics(network, hardware);
    Grasp grasp;
    if (network.fingers > 1 && dice.chance(0.5)) grasp.held = 1;
    const int motors = carriage_count(network);
    grasp.carriages.given = static_cast<std::uint8_t>(motors);
    for (int c = 0; c < motors; ++c) {
      grasp.carriages.over_D[static_cast<std::size_t>(c)] = dice.real(0.3, 1);
    }
    TensionState state;
    TensionSolver().solve(network, parts, grasp, Direction::pull, state);
    if (!state.in_range) continue;
    SCOPED_TRACE(seed);
    const FingerPullArray pulls = finger_pulls_of(network, parts, state);
    const GripDemand demand =
        grip_demand(known, network.fingers, testing::pulls_in(network, parts, grasp), grasp);
    double low = 0;
    double high = 1e7;
    if (!reaches_all(known, network, pulls, grasp, high)) {
      EXPECT_GT(demand.motor_force_N, 1e6);
      continue;
    }
    for (int step = 0; step < 80; ++step) {
      const double middle = (low + high) / 2;
      (reaches_all(known, network, pulls, grasp, middle) ? high : low) = middle;
    }
    ++found;
    double most = 0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(motors); ++c) {
      expect_alike(demand.motors_N[c], high * state.motor_tension[c]);
      most = std::max(most, high * state.motor_tension[c]);
    }
    expect_alike(demand.motor_force_N, most);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(found, 150);
}

}  // namespace
}  // namespace reeve
