// How fingers close whose strands lie on two tendons, against the conditions of the least motion.
#include "core/tension/split_kinematics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "core/notation.hpp"
#include "core/tension/seizure.hpp"
#include "core/tension/tied_split_kinematics.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

SplitClosing closing(const std::string& word, const std::vector<std::string>& contacts,
                     Grasp grasp = {}, const Hardware& hardware = {}) {
  const Network network = expand(parse_routing(word));
  std::vector<std::size_t> indices;
  for (const auto& contact : contacts) indices.push_back(find_contact(network, contact).value());
  return split_closing(seize(network, indices).network, mechanics(network, hardware), grasp);
}

TEST(SplitClosing, WithoutASeizedTipIsTheUsualSharing) {
  const SplitClosing s = closing("M-1-T-2-F", {});
  EXPECT_NEAR(s.closing[0], 0.25, 1e-12);
  EXPECT_NEAR(s.closing[1], 0.25, 1e-12);
}

// Minimise dl1²/w1 + dl2²/w2 subject to 2 dl1 + dl2 = m: dl_f in proportion to w_f times strands.
// m is 1 for the carriage itself and 2 for a block that it pulls; nothing pulls T4.
TEST(SplitClosing, SharesByWeightAndStrands) {
  Hardware hardware;
  hardware.fingers.push_back({1, {}, {}, {}, {}, {}, 3});
  for (const auto& [word, given, slack] :
       {std::tuple<std::string, double, std::vector<char>>{"M-1-T-2-F", 1, {0, 1}},
        {"M-Y1+F-1-Y1-2-F", 2, {0, 0, 1}}}) {
    SCOPED_TRACE(word);
    const SplitClosing s = closing(word, {"T3-T4"}, {}, hardware);
    EXPECT_NEAR(s.closing[0], given * 6 / 13, 1e-9);
    EXPECT_NEAR(s.closing[1], given * 1 / 13, 1e-9);
    EXPECT_EQ(s.slack, slack);
  }
}

// A block gives up two for one of the carriage, and each strand that passes it is served once.
TEST(TiedSplitClosing, MovesABlockByWhatItsTailGivesUp) {
  const Network network = expand(parse_routing("M-Y1+F-1-Y1-2-F"));
  const SplitClosing s = tied_split_closing(network, mechanics(network, Hardware{}), Grasp{});
  EXPECT_NEAR(s.block_travel[0], 1, 1e-9);
  EXPECT_NEAR(s.closing[0], 0.5, 1e-9);
  EXPECT_NEAR(s.closing[1], 0.5, 1e-9);
}

TEST(SplitClosing, HoldsForExtremeWeights) {
  Hardware hardware;
  hardware.fingers.push_back({1, {}, {}, {}, {}, {}, 1e-3});
  hardware.fingers.push_back({2, {}, {}, {}, {}, {}, 1e3});
  // dl1 >= 1, dl1 + 2 dl2 >= 3.
  const SplitClosing s = closing("M-1-P-2-M", {"T1-T2"}, {}, hardware);
  EXPECT_NEAR(s.closing[0], 1, 1e-9);
  EXPECT_NEAR(s.closing[1], 1, 1e-9);
  // The willing finger closes nearly three, of which the piece with its other strand needs one.
  const SplitClosing t = closing("M-2-P-1-M", {"T3-T4"}, {}, hardware);
  EXPECT_NEAR(t.closing[1], 3 * 1e3 / (1e3 + 4e-3), 1e-9);
  EXPECT_NEAR(t.closing[0], 3 * 2e-3 / (1e3 + 4e-3), 1e-9);
  EXPECT_EQ(t.slack, (std::vector<char>{1, 0}));
}

struct PieceSums {
  double motor_sides = 0;
  double given = 0;
};

PieceSums sums(const Network& network, const TendonSpan& tendon,
               const std::vector<double>& closing) {
  PieceSums result;
  for (std::size_t i = tendon.first_segment; i < tendon.first_segment + tendon.segments; ++i) {
    const Segment& segment = network.segments[i];
    if (segment.kind == SegmentKind::motor_side) result.motor_sides += 1;
    if (segment.kind == SegmentKind::strand) {
      result.given += closing[static_cast<std::size_t>(segment.finger - 1)];
    }
  }
  return result;
}

// Nothing held closes, every pulled tendon gives up what it must, and one that gives up more is
// slack.
TEST(SplitClosing, ServesEveryTendonOfRandomRoutings) {
  int slack = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    const testing::Trial trial = testing::random_trial(seed);
    SCOPED_TRACE(testing::to_text(trial));
    testing::Dice dice(seed);
    std::vector<std::size_t> contacts;
    for (int i = 0; i < 2; ++i) {
      const auto k = static_cast<std::size_t>(
          dice.integer(0, static_cast<int>(trial.network.contacts.size()) - 1));
      if (std::find(contacts.begin(), contacts.end(), k) == contacts.end()) contacts.push_back(k);
    }
    const Network network = seize(trial.network, contacts).network;
    const SplitClosing s =
        split_closing(network, mechanics(trial.network, trial.hardware), trial.grasp);
    for (int f = 1; f <= network.fingers; ++f) {
      const double dl = s.closing[static_cast<std::size_t>(f - 1)];
      EXPECT_GE(dl, 0);
      if (trial.grasp.holds(f)) {
        EXPECT_EQ(dl, 0);
      }
    }
    for (std::size_t t = 0; t < network.tendons.size(); ++t) {
      const PieceSums piece = sums(network, network.tendons[t], s.closing);
      if (s.jams[t] != 0) continue;
      if (piece.motor_sides > 0) {
        EXPECT_GE(piece.given, piece.motor_sides - 1e-9);
      }
      if (s.slack[t] == 0) {
        EXPECT_NEAR(piece.given, piece.motor_sides, 1e-8);
      }
      slack += s.slack[t];
    }
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(slack, 100);
}

}  // namespace
}  // namespace reeve
