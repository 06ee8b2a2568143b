// Trees and tackles against the independent solver: three thousand at random in every run.
// REEVE_MECHANISMS=N tries N of them. Some against pulling in small steps, too.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "tests/search/generated.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/random_routing.hpp"
#include "tests/support/reference_comparison.hpp"
#include "tests/support/reference_loading.hpp"
#include "tests/support/reference_words.hpp"

namespace reeve {
namespace {

using testing::Dice;
using testing::ReferenceHardware;

std::uint64_t trials() {
  const char* wanted = std::getenv("REEVE_MECHANISMS");
  return wanted == nullptr ? 3000 : std::strtoull(wanted, nullptr, 10);
}

struct SeenMechanisms {
  int jams = 0;
  int released = 0;
  int loops = 0;
  int bars = 0;
  int tackles = 0;  // a block is passed more than once
  int sticking = 0;
};

void count(const Network& network, const TensionState& state, SeenMechanisms& seen) {
  seen.jams += state.jams;
  for (const TendonSpan& tendon : network.tendons) seen.loops += tendon.closed;
  std::multiset<std::size_t> passes;
  bool sticks = false;
  for (std::size_t k = 0; k < network.contacts.size(); ++k) {
    const Contact& contact = network.contacts[k];
    seen.bars += contact.kind == ContactKind::bar;
    if (contact.block != no_block) passes.insert(contact.block);
    sticks |= !state.jams && state.slip[k] == 0;
  }
  seen.sticking += sticks;
  seen.tackles += std::set<std::size_t>(passes.begin(), passes.end()).size() < passes.size();
}

TEST(ReferenceProperty, TreesAndTacklesAreThoseOfAnIndependentSolver) {
  SeenMechanisms seen;
  std::uint64_t refused = 0;
  std::uint64_t unsolved = 0;
  for (std::uint64_t seed = 1; seed <= trials(); ++seed) {
    Dice dice(seed);
    const std::string word = testing::random_mechanism(dice);
    const ReferenceHardware hardware = testing::random_reference_hardware(dice, word);
    const Network network = expand(parse_routing(word));
    const Grasp grasp = testing::random_grasp(dice, network.fingers);
    const Direction direction = dice.chance(0.7) ? Direction::pull : Direction::release;
    SCOPED_TRACE(std::to_string(seed) + ": " + word + ", held " + to_text(grasp) +
                 (direction == Direction::pull ? ", pulled" : ", released"));
    const Mechanics m = testing::mechanics_of(network, hardware);
    TensionState state;
    TensionSolver().solve(network, m, grasp, direction, state);
    const auto reference = [&] {
      return testing::reference_tensions(word, grasp, direction, hardware);
    };
    if (!state.in_range) {
      // A finger would have to open, or blocks move as they like; or a rope that shares blocks with
      // others in a ring takes the motor's part.
      try {
        reference();
        ++unsolved;
      } catch (const std::invalid_argument&) {
        ++refused;
      }
      continue;
    }
    seen.released += direction == Direction::release;
    count(network, state, seen);
    const auto expected = reference();
    EXPECT_EQ(testing::disagreement(word, expected, testing::observed(network, m, state)), "");
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_LT(refused, trials() / 50);
  EXPECT_LE(unsolved, trials() / 10000);  // none in a usual run
  for (const int cases :
       {seen.jams, seen.released, seen.loops, seen.bars, seen.tackles, seen.sticking}) {
    EXPECT_GT(cases, 50);
  }
}

bool has_more_than_plain_blocks(const Routing& routing) {
  if (block_count(routing).bars > 0) return true;
  return std::any_of(routing.tendons.begin(), routing.tendons.end(), [](const Tendon& tendon) {
    const auto many = [&](TokenKind kind) {
      return std::count_if(tendon.walk.begin(), tendon.walk.end(),
                           [&](const Token& token) { return token.kind == kind; });
    };
    return many(TokenKind::block_pass) > 1 || many(TokenKind::becket) > 0 ||
           (tendon.walk.size() == 2 && many(TokenKind::block_tail) == 2);
  });
}

TEST(ReferenceProperty, OfMoreThanPlainBlocksAreThoseOfAnIndependentSolver) {
  const search::PartSet few = testing::with_blocks(testing::anchored(search::full_parts()), 4);
  int solved = 0;
  for (const search::PartSet& parts :
       {testing::linked(few), testing::in_series(few), testing::linked(testing::in_series(few)),
        testing::barred(few), testing::barred(testing::linked(testing::in_series(few))),
        testing::becketed(few), testing::passed_twice(few),
        testing::becketed(testing::barred(testing::passed_twice(few)))}) {
    for (int fingers = 2; fingers <= 5; ++fingers) {
      search::RoutingGenerator generator(
          testing::generating(parts, fingers, testing::identical, true));
      std::mt19937_64 engine(static_cast<std::uint64_t>(fingers));
      Dice dice(engine());
      for (int i = 0; i < 150; ++i) {
        Routing routing;
        generator.seek(engine() % generator.total());
        generator.next(routing);
        if (!is_actuated(routing) || !has_more_than_plain_blocks(routing)) continue;
        const std::string word = to_word(routing);
        const ReferenceHardware hardware = testing::random_reference_hardware(dice, word);
        const Network network = expand(routing);
        const Grasp grasp = testing::random_grasp(dice, fingers);
        SCOPED_TRACE(word + ", held " + to_text(grasp));
        const Mechanics m = testing::mechanics_of(network, hardware);
        TensionState state;
        TensionSolver().solve(network, m, grasp, Direction::pull, state);
        const auto expected = testing::reference_tensions(word, grasp, Direction::pull, hardware);
        EXPECT_EQ(testing::disagreement(word, expected, testing::observed(network, m, state),
                                        {.tension = 1e-9}),
                  "");
        ++solved;
      }
    }
  }
  EXPECT_GT(solved, 500);
}

double greatest_difference(const Network& network, const TensionState& limit,
                           const std::map<std::string, double>& loaded) {
  double greatest = 0;
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    const double tension = limit.tension[i];
    const double off = loaded.at(segment_name(network.segments[i])) - tension;
    greatest = std::max(greatest, std::abs(off) / std::max(1.0, tension));
  }
  return greatest;
}

// Four times the steps leave a quarter of what the start of the loading has left.
TEST(ReferenceProperty, TreesAndTacklesAreTheLimitOfPullingInSmallSteps) {
  int compared = 0;
  int approached = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    Dice dice(seed);
    const std::string word = testing::random_mechanism(dice);
    const ReferenceHardware hardware = testing::random_reference_hardware(dice, word);
    const Network network = expand(parse_routing(word));
    const Grasp grasp = testing::random_grasp(dice, network.fingers);
    SCOPED_TRACE(std::to_string(seed) + ": " + word + ", held " + to_text(grasp));
    TensionState state;
    TensionSolver().solve(network, testing::mechanics_of(network, hardware), grasp, Direction::pull,
                          state);
    if (!state.in_range || state.jams) continue;
    const std::vector<int> held = held_fingers(grasp);
    const auto off_after = [&](int steps) {
      return greatest_difference(
          network, state,
          testing::loaded_tensions(word, {held.begin(), held.end()}, hardware, steps));
    };
    try {
      const double coarse = off_after(20);
      EXPECT_LE(off_after(80), 0.35 * coarse + 1e-9);
      ++compared;
      approached += coarse > 1e-6;
    } catch (const std::logic_error&) {
    }
  }
  EXPECT_GT(compared, 80);
  EXPECT_GT(approached, 10);
}

}  // namespace
}  // namespace reeve
