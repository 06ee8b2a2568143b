// Does more friction at one contact always cost efficiency? Where the carriage pulls one segment,
// yes. Where it pulls several, no: the efficiency of the motor is then a mean over these segments,
// weighted by their tensions, and friction also shifts tension from one to the other.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "core/notation.hpp"
#include "core/performance.hpp"
#include "core/tension/tension.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using testing::Dice;
using testing::Trial;

int motor_side_count(const Network& network) {
  int count = 0;
  for (const Segment& segment : network.segments) count += segment.kind == SegmentKind::motor_side;
  return count;
}

// In a jam nothing slides and no work is done; tensions are elastic only.
bool jams(const Trial& trial) {
  return tensions(trial.network, mechanics(trial.network, trial.hardware), trial.grasp,
                  trial.direction)
      .jams;
}

void add_friction(Mechanics& m, std::size_t contact, double phi) {
  m.phi[contact] += phi;
  m.decay[contact] = std::exp(-m.phi[contact]);
}

Performance solved(const Trial& trial, const Mechanics& m) {
  return performance(trial.network, tensions(trial.network, m, trial.grasp, trial.direction),
                     trial.direction);
}

void expect_no_gain(const Trial& trial) {
  Dice dice(trial.seed + 555);
  const Mechanics m = mechanics(trial.network, trial.hardware);
  const Performance before = solved(trial, m);
  for (std::size_t k = 0; k < m.phi.size(); ++k) {
    Mechanics rougher = m;
    add_friction(rougher, k, dice.real(0.001, 1));
    const Performance after = solved(trial, rougher);
    EXPECT_LE(after.efficiency, before.efficiency * (1 + 1e-12)) << "contact " << k;
    EXPECT_LE(after.uniformity, before.uniformity * (1 + 1e-12)) << "contact " << k;
  }
}

TEST(FrictionProperty, WithOneMotorSideMoreFrictionNeverRaisesEfficiencyOrUniformity) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
    const Trial trial = testing::random_trial(seed, {1, 4, true, false});
    if (motor_side_count(trial.network) != 1 || jams(trial)) continue;
    SCOPED_TRACE(testing::to_text(trial));
    expect_no_gain(trial);
    ++found;
  }
  EXPECT_GT(found, 200);
}

// M-1-T-2-M with finger 1 held: T4 runs straight to its motor side b, while T3 runs round finger 1
// to a. Between them the tendon rests on the tip of finger 2 (exponent p), and T4 / T3 = e^p, the
// most that this tip can hold. The more it holds, the more of the load goes the short way: with
// x = e^{-2t}, y = e^p,
//
//   efficiency = (T3 + T4) / (a + b) = e^{-s} (x + x y) / (1 + x y),   rising with y.
double efficiency_of_tr2(double s, double t, double p) {
  const double x = std::exp(-2 * t);
  const double y = std::exp(p);
  return std::exp(-s) * (x + x * y) / (1 + x * y);
}

TEST(Friction, AtATipThatHoldsCanShiftLoadToTheShorterWayAndRaiseEfficiency) {
  const Network network = expand(parse_routing("M-1-T-2-M"));  // a T1 T2 T3 T4 b
  const std::size_t tip_of_finger_2 = 3;
  const Hardware hardware;
  const double s = hardware.sheath.exponent();
  const double t = hardware.tube.exponent();
  double last = 0;
  for (const double more : {0.0, 0.1, 0.2, 0.3}) {
    Mechanics m = mechanics(network, hardware);
    add_friction(m, tip_of_finger_2, more);
    const TensionState state = tensions(network, m, hold({1}));
    ASSERT_EQ(state.slip[tip_of_finger_2], 0);
    const double efficiency = performance(network, state).efficiency;
    EXPECT_NEAR(efficiency, efficiency_of_tr2(s, t, t + more), 1e-12);
    EXPECT_GT(efficiency, last);
    last = efficiency;
  }
}

TEST(Friction, BeyondWhatATipHasToHoldChangesNothing) {
  const Network network = expand(parse_routing("M-1-T-2-M"));
  Mechanics m = mechanics(network, Hardware{});
  add_friction(m, 3, 2);
  const TensionState holding = tensions(network, m, hold({1}));
  add_friction(m, 3, 3);
  EXPECT_EQ(tensions(network, m, hold({1})).tension, holding.tension);
}

}  // namespace
}  // namespace reeve
