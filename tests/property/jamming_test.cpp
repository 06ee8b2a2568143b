// Grasps in which routings jam, against the tension solver in every one of them.
#include "core/tension/jamming.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/random_rigging.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using testing::Dice;

struct JamTally {
  int routings = 0;
  int with_blocks = 0;
  int that_jam = 0;
  int that_move = 0;
};

std::vector<Grasp> jamming_grasps(const Network& network, const Mechanics& numbers) {
  std::vector<Grasp> jamming;
  TensionSolver solver;
  TensionState state;
  for (const WeightedGrasp& weighted : all_grasps(network.fingers)) {
    solver.solve(network, numbers, weighted.grasp, Direction::pull, state);
    if (state.jams) jamming.push_back(weighted.grasp);
  }
  return jamming;
}

// Returns the smallest sets by the definition: no set within them jams.
std::vector<Grasp> smallest_of(const std::vector<Grasp>& jamming) {
  std::vector<Grasp> smallest;
  for (const Grasp& grasp : jamming) {
    const bool holds_another = std::any_of(jamming.begin(), jamming.end(), [&](Grasp other) {
      return !(other == grasp) && (grasp.held & other.held) == other.held;
    });
    if (!holds_another) smallest.push_back(grasp);
  }
  const auto order = [](Grasp a, Grasp b) {
    const auto in_order = [](Grasp g) {
      const std::vector<int> fingers = held_fingers(g);
      return std::pair(fingers.size(), fingers);
    };
    return in_order(a) < in_order(b);
  };
  std::sort(smallest.begin(), smallest.end(), order);
  return smallest;
}

// Draws the shares of the fingers, which alone in a hardware bear on where fingers can go.
Hardware closing_unlike(Dice& dice, int fingers) {
  Hardware hardware;
  for (int number = 1; number <= fingers; ++number) {
    if (dice.chance(0.5)) continue;
    FingerHardware& finger = hardware.fingers.emplace_back();
    finger.finger = number;
    finger.closing = dice.log_real(0.1, 10);
  }
  return hardware;
}

void compare_jams(const Routing& routing, Dice& dice, JamFinder& finder, JamTally& tally) {
  const Network network = expand(routing);
  // A routing that no motor pulls has no tensions.
  if (!is_actuated(routing)) return;
  const Mechanics numbers = mechanics(network, closing_unlike(dice, network.fingers));
  const std::vector<Grasp> jamming = jamming_grasps(network, numbers);
  EXPECT_EQ(finder.grasps(network, numbers), static_cast<double>(jamming.size()))
      << to_word(routing);
  EXPECT_EQ(finder.smallest(network, numbers), smallest_of(jamming)) << to_word(routing);
  ++tally.routings;
  if (!network.blocks.empty()) ++tally.with_blocks;
  ++(jamming.empty() ? tally.that_move : tally.that_jam);
}

TEST(Jamming, OfRandomRoutingsIsWhatTheSolverFindsInEveryGrasp) {
  Dice dice(4711);
  JamFinder finder;
  JamTally tally;
  for (int i = 0; i < 700; ++i) compare_jams(testing::random_routing(dice), dice, finder, tally);
  for (int i = 0; i < 3000; ++i) compare_jams(testing::random_rigging(dice), dice, finder, tally);
  for (int i = 0; i < 300; ++i) {
    compare_jams(parse_routing(testing::random_mechanism(dice)), dice, finder, tally);
  }
  EXPECT_GT(tally.routings, 1500);
  EXPECT_GT(tally.with_blocks, 700);
  EXPECT_GT(tally.that_jam, 400);
  EXPECT_GT(tally.that_move, 400);
}

}  // namespace
}  // namespace reeve
