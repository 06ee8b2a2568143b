// What every solution owes to physics, whatever the routing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "core/performance.hpp"
#include "core/tension/tension.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using testing::RoutingRange;
using testing::Trial;

struct Solution {
  Trial trial;
  Mechanics mechanics;
  TensionState state;

  const Network& network() const { return trial.network; }
};

Solution solve(const Trial& trial, const Hardware& hardware) {
  const Mechanics m = mechanics(trial.network, hardware);
  return {trial, m, tensions(trial.network, m, trial.grasp, trial.direction)};
}

using Check = std::function<void(const Solution&)>;

void for_each_solution(const Check& check, const RoutingRange& range = {1, 6, true, true}) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    const Trial trial = testing::random_trial(seed, range);
    SCOPED_TRACE(testing::to_text(trial));
    check(solve(trial, trial.hardware));
    if (::testing::Test::HasFailure()) return;
  }
}

using ContactCheck = std::function<void(std::size_t contact, double left, double right)>;

void for_each_contact(const Solution& s, const ContactCheck& check) {
  for (const TendonSpan& tendon : s.network().tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const auto [left, right] = ends_of(tendon, k);
      check(tendon.first_contact + k, s.state.tension[left], s.state.tension[right]);
    }
  }
}

bool is_motor_side(const Segment& segment) { return segment.kind == SegmentKind::motor_side; }

// Σ T_i dl_i over the strands, at D = 1.
double work_of_fingers(const Solution& s) {
  double work = 0;
  for (std::size_t i = 0; i < s.network().segments.size(); ++i) {
    const Segment& segment = s.network().segments[i];
    if (segment.kind != SegmentKind::strand) continue;
    work += s.state.tension[i] * s.state.closing[static_cast<std::size_t>(segment.finger - 1)];
  }
  return work;
}

double friction_loss(const Solution& s) {
  double loss = 0;
  for_each_contact(s, [&](std::size_t k, double left, double right) {
    loss += std::abs(s.state.slip[k]) * std::abs(left - right);
  });
  return loss;
}

TEST(PhysicsProperty, WorkIsBalanced) {
  for_each_solution([](const Solution& s) {
    if (s.state.jams) return;
    const double fingers = work_of_fingers(s);
    const double motor = 1;  // T_M D
    if (s.trial.direction == Direction::pull) {
      EXPECT_NEAR(motor, fingers + friction_loss(s), 1e-9);
    } else {
      EXPECT_NEAR(fingers, motor + friction_loss(s), 1e-9 * fingers);
    }
  });
}

TEST(PhysicsProperty, ThereIsAJamExactlyIfSomeTendonHasNoFingerToMove) {
  for_each_solution([](const Solution& s) {
    bool blocked = false;
    for (const Tendon& tendon : s.trial.routing.tendons) {
      blocked |= std::none_of(tendon.walk.begin(), tendon.walk.end(), [&](const Token& token) {
        return token.kind == TokenKind::finger && !s.trial.grasp.holds(token.finger);
      });
    }
    EXPECT_EQ(s.state.jams, blocked);
  });
}

TEST(PhysicsProperty, EfficiencyIsNeverMoreThanTheBestSheathLetsThrough) {
  for_each_solution([](const Solution& s) {
    double best_sheath = 0;
    for (std::size_t k = 0; k < s.network().contacts.size(); ++k) {
      if (s.network().contacts[k].kind != ContactKind::sheath) continue;
      best_sheath = std::max(best_sheath, s.mechanics.decay[k]);
    }
    const Performance found = performance(s.network(), s.state, s.trial.direction);
    EXPECT_LE(found.efficiency, best_sheath * (1 + 1e-9));
    EXPECT_GE(found.efficiency, 0);
  });
}

// ---- without friction ----

Hardware frictionless(const Hardware& hardware) {
  Hardware smooth = hardware;
  smooth.tube.mu = smooth.bearing.mu = smooth.sheath.mu = 0;
  for (FingerHardware& finger : smooth.fingers) finger.tip_mu = finger.sheath_mu = std::nullopt;
  smooth.contacts.clear();
  return smooth;
}

void for_each_frictionless_solution(const Check& check, const RoutingRange& range = {}) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const Trial trial = testing::random_trial(seed, range);
    SCOPED_TRACE(testing::to_text(trial));
    check(solve(trial, frictionless(trial.hardware)));
    if (::testing::Test::HasFailure()) return;
  }
}

// So with one tendon all fingers feel the same; with several, each tendon's tension is its take-up
// (one travel for each motor side) over its length.
double motor_sides_per_length(const Solution& s, const TendonSpan& tendon) {
  double motor_sides = 0;
  double length = 0;
  for (std::size_t i = tendon.first_segment; i < tendon.first_segment + tendon.segments; ++i) {
    motor_sides += is_motor_side(s.network().segments[i]);
    length += s.mechanics.length[i];
  }
  return motor_sides / length;
}

TEST(FrictionlessProperty, TendonsDifferByMotorSidesPerLengthOnly) {
  for_each_frictionless_solution([](const Solution& s) {
    if (s.state.jams) return;
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    for (const TendonSpan& tendon : s.network().tendons) {
      least = std::min(least, motor_sides_per_length(s, tendon));
      most = std::max(most, motor_sides_per_length(s, tendon));
    }
    EXPECT_NEAR(performance(s.network(), s.state).uniformity, least / most, 1e-9);
  });
}

}  // namespace
}  // namespace reeve
