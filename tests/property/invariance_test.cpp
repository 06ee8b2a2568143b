// What a solution must not depend on: the unit of length, how a tendon is walked, the names of
// fingers, the order of tendons, and what the solver solved before.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>
#include <vector>

#include "core/tension/tension.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using testing::Dice;
using testing::Trial;

constexpr double tolerance = 1e-9;

void for_each_trial(int count, const std::function<void(const Trial&, const Mechanics&)>& check) {
  for (int seed = 1; seed <= count; ++seed) {
    const Trial trial = testing::random_trial(static_cast<std::uint64_t>(seed), {1, 6, true, true});
    SCOPED_TRACE(testing::to_text(trial));
    check(trial, mechanics(trial.network, trial.hardware));
    if (::testing::Test::HasFailure()) return;
  }
}

TensionState solve(const Trial& trial, const Mechanics& m) {
  return tensions(trial.network, m, trial.grasp, trial.direction);
}

// Another description of the same thing: for each segment and contact, where it stands in the first
// one.
struct Redescribed {
  Routing routing;
  std::vector<std::size_t> segment;
  std::vector<std::size_t> contact;
  std::vector<int> finger;  // new number → old number
};

Mechanics redescribed(const Mechanics& m, const Redescribed& other) {
  Mechanics result;
  for (const std::size_t i : other.segment) result.length.push_back(m.length[i]);
  for (const std::size_t k : other.contact) {
    result.phi.push_back(m.phi[k]);
    result.decay.push_back(m.decay[k]);
  }
  for (const int f : other.finger) {
    result.closing.push_back(m.closing[static_cast<std::size_t>(f - 1)]);
  }
  return result;
}

Grasp redescribed(Grasp grasp, const Redescribed& other) {
  Grasp result;
  for (std::size_t f = 0; f < other.finger.size(); ++f) {
    if (grasp.holds(other.finger[f])) result.held |= hold({static_cast<int>(f) + 1}).held;
  }
  return result;
}

// Slips are not compared: a loop whose least friction loss is not unique may turn otherwise when it
// is walked otherwise.
void expect_same_tensions(const Trial& trial, const Mechanics& m, const Redescribed& other) {
  const TensionState before = solve(trial, m);
  const TensionState after = tensions(expand(other.routing), redescribed(m, other),
                                      redescribed(trial.grasp, other), trial.direction);
  EXPECT_EQ(after.jams, before.jams);
  ASSERT_EQ(after.tension.size(), before.tension.size());
  for (std::size_t i = 0; i < after.tension.size(); ++i) {
    const double tension = before.tension[other.segment[i]];
    EXPECT_NEAR(after.tension[i], tension, tolerance * tension) << "segment " << i;
  }
  for (std::size_t f = 0; f < after.closing.size(); ++f) {
    EXPECT_NEAR(after.closing[f], before.closing[static_cast<std::size_t>(other.finger[f] - 1)],
                tolerance);
  }
}

std::vector<int> same_fingers(const Trial& trial) {
  std::vector<int> fingers(static_cast<std::size_t>(trial.network.fingers));
  std::iota(fingers.begin(), fingers.end(), 1);
  return fingers;
}

void append_span(std::vector<std::size_t>& order, std::size_t first, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) order.push_back(first + i);
}

// ---- the unit of length ----

TEST(InvarianceProperty, OnlyRatiosOfLengthsMatter) {
  for_each_trial(500, [](const Trial& trial, const Mechanics& m) {
    Mechanics longer = m;
    for (double& length : longer.length) length *= 37.5;
    const TensionState before = solve(trial, m);
    const TensionState after = solve(trial, longer);
    for (std::size_t i = 0; i < before.tension.size(); ++i) {
      EXPECT_NEAR(after.tension[i], before.tension[i], tolerance * before.tension[i]);
    }
    EXPECT_EQ(after.slip, before.slip);
  });
}

// ---- tendons walked backwards ----

Redescribed walked_backwards(const Trial& trial) {
  Redescribed other{trial.routing, {}, {}, same_fingers(trial)};
  for (Tendon& tendon : other.routing.tendons) {
    std::reverse(tendon.walk.begin(), tendon.walk.end());
    if (tendon.closed) std::rotate(tendon.walk.begin(), tendon.walk.end() - 1, tendon.walk.end());
  }
  for (const TendonSpan& tendon : trial.network.tendons) {
    append_span(other.segment, tendon.first_segment, tendon.segments);
    append_span(other.contact, tendon.first_contact, tendon.contacts);
    std::reverse(other.segment.end() - static_cast<std::ptrdiff_t>(tendon.segments),
                 other.segment.end());
    // The contact that closes a loop, at its first finger, stays the last.
    const std::ptrdiff_t closing = tendon.closed ? 1 : 0;
    std::reverse(other.contact.end() - static_cast<std::ptrdiff_t>(tendon.contacts),
                 other.contact.end() - closing);
  }
  return other;
}

TEST(InvarianceProperty, TensionsDoNotDependOnTheDirectionOfTheWalk) {
  for_each_trial(1000, [](const Trial& trial, const Mechanics& m) {
    expect_same_tensions(trial, m, walked_backwards(trial));
  });
}

// Friction that takes the tension over tens of decades, segments a million times as long as others.
Mechanics rough_and_uneven(Mechanics m, Dice& dice) {
  for (std::size_t k = 0; k < m.phi.size(); ++k) {
    m.phi[k] = dice.chance(0.1) ? 0 : dice.real(0, 10);
    m.decay[k] = std::exp(-m.phi[k]);
  }
  for (double& length : m.length) length = dice.log_real(1e-3, 1e3);
  return m;
}

TEST(InvarianceProperty, TensionsDoNotDependOnTheDirectionOfTheWalkHoweverRoughItIs) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const Trial trial = testing::random_trial(seed, {1, 8, true, true});
    SCOPED_TRACE(testing::to_text(trial));
    Dice dice(seed + 3333);
    const Mechanics m = rough_and_uneven(mechanics(trial.network, trial.hardware), dice);
    expect_same_tensions(trial, m, walked_backwards(trial));
    if (::testing::Test::HasFailure()) return;
  }
}

// ---- loops entered at another finger ----

// How far along the arrays of the first description the loop's new first finger stands.
std::size_t shift_to(const Trial& trial, const TendonSpan& tendon, int finger) {
  for (std::size_t k = 0; k < tendon.contacts; ++k) {
    const Contact& contact = trial.network.contacts[tendon.first_contact + k];
    if (contact.place == ContactPlace::tip && contact.finger == finger) return k + 1;
  }
  return 0;
}

void enter_at_next_finger(Tendon& tendon) {
  do {
    std::rotate(tendon.walk.begin(), tendon.walk.begin() + 1, tendon.walk.end());
  } while (tendon.walk.front().kind != TokenKind::finger);
}

void append_turned(std::vector<std::size_t>& order, std::size_t first, std::size_t count,
                   std::size_t shift) {
  for (std::size_t i = 0; i < count; ++i) order.push_back(first + (i + shift) % count);
}

Redescribed entered_elsewhere(const Trial& trial) {
  Redescribed other{trial.routing, {}, {}, same_fingers(trial)};
  for (std::size_t t = 0; t < trial.network.tendons.size(); ++t) {
    const TendonSpan& tendon = trial.network.tendons[t];
    std::size_t shift = 0;
    if (tendon.closed) {
      enter_at_next_finger(other.routing.tendons[t]);
      shift = shift_to(trial, tendon, other.routing.tendons[t].walk.front().finger);
    }
    append_turned(other.segment, tendon.first_segment, tendon.segments, shift);
    append_turned(other.contact, tendon.first_contact, tendon.contacts, shift);
  }
  return other;
}

TEST(InvarianceProperty, TensionsDoNotDependOnWhereALoopIsEntered) {
  for_each_trial(1000, [](const Trial& trial, const Mechanics& m) {
    expect_same_tensions(trial, m, entered_elsewhere(trial));
  });
}

// ---- names and order ----

Redescribed relabelled(const Trial& trial, Dice& dice) {
  Redescribed other{{}, {}, {}, same_fingers(trial)};
  dice.shuffle(other.finger);
  std::vector<std::size_t> tendons(trial.network.tendons.size());
  std::iota(tendons.begin(), tendons.end(), std::size_t{0});
  dice.shuffle(tendons);
  std::vector<int> new_name(other.finger.size() + 1);
  for (std::size_t f = 0; f < other.finger.size(); ++f) {
    new_name[static_cast<std::size_t>(other.finger[f])] = static_cast<int>(f) + 1;
  }
  for (const std::size_t t : tendons) {
    other.routing.tendons.push_back(trial.routing.tendons[t]);
    for (Token& token : other.routing.tendons.back().walk) {
      if (token.kind == TokenKind::finger) token = finger(new_name[token.finger], token.tip);
    }
    const TendonSpan& span = trial.network.tendons[t];
    append_span(other.segment, span.first_segment, span.segments);
    append_span(other.contact, span.first_contact, span.contacts);
  }
  return other;
}

TEST(InvarianceProperty, TensionsDoNotDependOnTheNamesOfFingersAndTheOrderOfTendons) {
  for_each_trial(1000, [](const Trial& trial, const Mechanics& m) {
    Dice dice(trial.seed + 7777);
    expect_same_tensions(trial, m, relabelled(trial, dice));
  });
}

// ---- what was solved before ----

bool same_bytes(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

TEST(InvarianceProperty, AUsedSolverGivesTheBytesOfAFreshOne) {
  TensionSolver used;
  TensionState state;
  for_each_trial(1000, [&](const Trial& trial, const Mechanics& m) {
    used.solve(trial.network, m, trial.grasp, trial.direction, state);
    const TensionState fresh = solve(trial, m);
    EXPECT_TRUE(same_bytes(state.tension, fresh.tension));
    EXPECT_TRUE(same_bytes(state.slip, fresh.slip));
    EXPECT_TRUE(same_bytes(state.closing, fresh.closing));
    EXPECT_EQ(state.jams, fresh.jams);
  });
}

TEST(InvarianceProperty, AUsedNetworkAndUsedMechanicsAreThoseOfFreshOnes) {
  Network network;
  Mechanics reused;
  for_each_trial(500, [&](const Trial& trial, const Mechanics& fresh) {
    expand(trial.routing, network);
    MechanicsBuilder(trial.hardware).apply(network, reused);
    EXPECT_TRUE(same_bytes(reused.length, fresh.length));
    EXPECT_TRUE(same_bytes(reused.phi, fresh.phi));
    EXPECT_TRUE(same_bytes(reused.decay, fresh.decay));
    EXPECT_TRUE(same_bytes(reused.closing, fresh.closing));
  });
}

}  // namespace
}  // namespace reeve
