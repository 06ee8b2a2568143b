// What holds for any tree or tackle: every block in balance, every contact in its cone, no work won
// or lost but by friction, and one canonical word however it is written.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/canonical.hpp"
#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "core/tension/tree_kinematics.hpp"
#include "tests/property/rewritten.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using testing::Dice;

constexpr double balance_error = 1e-9;

// Draws friction of every kind of contact, or none at all.
Hardware random_laws(Dice& dice) {
  const double scale = dice.chance(0.3) ? 0 : 1;
  Hardware hardware;
  hardware.tube.mu = scale * dice.real(0, 0.3);
  hardware.bearing.mu = scale * dice.real(0, 0.05);
  hardware.sheath.mu = scale * dice.real(0, 0.2);
  hardware.block = ContactLaw{scale * dice.real(0, 0.1), 3};
  return hardware;
}

void expect_blocks_in_balance(const Network& network, const TensionState& state) {
  std::vector<double> off(network.blocks.size(), 0);
  std::vector<double> size(network.blocks.size(), 0);
  for (const TendonSpan& tendon : network.tendons) {
    for_each_pull(network, tendon,
                  [&](std::size_t segment, std::size_t block, double sign, double) {
                    off[block] += sign * state.tension[segment];
                    size[block] += state.tension[segment];
                  });
  }
  for (std::size_t b = 0; b < off.size(); ++b) {
    EXPECT_NEAR(off[b], 0, balance_error * std::max(size[b], 1.0)) << block_name(network.blocks[b]);
  }
}

// The work that friction takes, per unit of carriage travel.
double expect_contacts_in_cones(const Network& network, const Mechanics& m,
                                const TensionState& state) {
  double lost = 0;
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const std::size_t contact = tendon.first_contact + k;
      const double left = state.tension[ends_of(tendon, k).left];
      const double right = state.tension[ends_of(tendon, k).right];
      const std::size_t block = network.contacts[contact].block;
      if (network.contacts[contact].kind == ContactKind::bar) {
        const ArmRatio& arms = network.blocks[block].arms;
        EXPECT_NEAR(left * arms.right, right * arms.left, balance_error * left * arms.right);
        continue;
      }
      const double slip = state.slip[contact];
      const double margin = balance_error * std::max(left, right);
      EXPECT_LE(left * m.decay[contact], right + margin);
      EXPECT_LE(right * m.decay[contact], left + margin);
      if (slip != 0) {
        const auto [low, high] = slip > 0 ? std::pair(left, right) : std::pair(right, left);
        EXPECT_NEAR(low, high * m.decay[contact], margin);
      }
      lost += std::abs(slip * (left - right));
    }
  }
  return lost;
}

double work_on_fingers(const Network& network, const TensionState& state) {
  double work = 0;
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    const Segment& segment = network.segments[i];
    if (segment.kind != SegmentKind::strand) continue;
    work += state.tension[i] * state.closing[static_cast<std::size_t>(segment.finger) - 1];
  }
  return work;
}

TEST(MechanismProperty, BlocksBalanceContactsKeepTheirConesAndNoWorkIsLost) {
  int moving = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    Dice dice(seed);
    const std::string word = testing::random_mechanism(dice);
    SCOPED_TRACE(std::to_string(seed) + ": " + word);
    const Network network = expand(parse_routing(word));
    const Mechanics m = mechanics(network, random_laws(dice));
    const Grasp grasp = testing::random_grasp(dice, network.fingers);
    for (const Direction direction : {Direction::pull, Direction::release}) {
      TensionState state;
      TensionSolver().solve(network, m, grasp, direction, state);
      if (!state.in_range) continue;
      expect_blocks_in_balance(network, state);
      const double lost = expect_contacts_in_cones(network, m, state);
      if (state.jams) continue;
      ++moving;
      const double work = work_on_fingers(network, state);
      const bool pull = direction == Direction::pull;
      EXPECT_NEAR(pull ? work + lost : work - lost, 1, balance_error * std::max(1.0, work));
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(moving, 2000);
}

TEST(MechanismProperty, HasOneCanonicalWordHoweverItIsWritten) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    Dice dice(seed);
    Routing routing = parse_routing(testing::random_mechanism(dice));
    if (seed % 2 == 0) routing = testing::with_several_motors(dice, routing);
    const Routing other = testing::disguised(testing::renamed(routing, dice), dice);
    const std::string word = to_word(canonical(routing, FingerIdentity::identical));
    ASSERT_EQ(to_word(canonical(other, FingerIdentity::identical)), word) << to_word(routing);
    ASSERT_EQ(to_word(canonical(parse_routing(word), FingerIdentity::identical)), word);
    ASSERT_EQ(to_word(parse_routing(to_word(other))), to_word(other));
  }
}

}  // namespace
}  // namespace reeve
