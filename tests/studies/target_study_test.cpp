// Ratios of the fingers' pulls against statics and the capstan law by hand.
#include "studies/target_study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/notation.hpp"
#include "core/performance.hpp"
#include "tests/studies/shipped_catalogue.hpp"

namespace reeve::testing {
namespace {

ExploreOptions explored(const PartSet& parts, int fingers) {
  ExploreOptions options;
  options.generator.fingers = fingers;
  options.generator.parts = parts;
  options.generator.identity = FingerIdentity::distinct;
  options.grasps = single_grasps(fingers);
  options.threads = 1;
  return options;
}

SizingOptions aiming_at(const std::string& target, int fingers,
                        const std::vector<std::string>& varied) {
  SizingOptions options;
  options.goal = parse_target(target, fingers);
  options.grasps = single_grasps(fingers);
  options.target_grasps = parse_grasps("none", fingers);
  for (const std::string& text : varied) options.varied.push_back(parse_varied(text));
  options.robust = false;
  options.starts = 1;
  options.threads = 1;
  return options;
}

// Returns finger 1's share of the pulls without friction; a fork halves, a movable pulley doubles.
double first_share(const std::string& word) {
  const GoalEvaluator goal(parse_routing(word), parse_target("others=1", 2),
                           parse_grasps("none", 2), authors_score());
  return goal.shares(with_friction_times(Model{}, 0)).at(0);
}

TEST(PullsWithoutFriction, AreThoseOfForksAndPulleys) {
  EXPECT_NEAR(first_share("M-1-T-2-F"), 0.5, 1e-9);
  // Two strands of one tendon pull twice as hard as one.
  EXPECT_NEAR(first_share("M-1-T-2x"), 2.0 / 3, 1e-9);
  // Each strand that passes the block has half of what pulls its tail.
  EXPECT_NEAR(first_share("M-Y1+1x-Y1-2x"), 0.5, 1e-9);
  EXPECT_NEAR(first_share("M-1-Y1+2x-Y1-F"), 2 / 2.5, 1e-9);
}

// True if the pulls without friction have this ratio, by the core's solver alone.
bool has_pulls(const Routing& routing, double ratio) {
  const Network network = expand(routing);
  for (const TendonSpan& tendon : network.tendons) {
    if (tendon.tree != network.tendons.front().tree) return false;
  }
  Mechanics plain = mechanics(network, Hardware{});
  plain.phi.assign(plain.phi.size(), 0.0);
  plain.decay.assign(plain.decay.size(), 1.0);
  const FingerArray pulls = pulls_by_finger(network, tensions(network, plain, Grasp{}));
  const double sum = pulls[1] + pulls[2];
  const double off = pulls[1] / sum - ratio / (1 + ratio);
  return sum > 0 && std::sqrt(2.0) * std::abs(off) <= met_miss;
}

TEST(Target, CountsAllDesignsThatMeetItByStatics) {
  const ExploreOptions options = explored(all_parts(), 2);
  const TargetReport report = target_study(
      options, aiming_at("1=2,others=1", 2, {"sheath_angle=4..9"}), shipped_catalogue());
  std::uint64_t expected = 0;
  RoutingGenerator generator(options.generator);
  for (Routing routing; generator.next(routing);) {
    if (is_actuated(routing) && has_pulls(routing, 2)) ++expected;
  }
  EXPECT_GT(expected, 0U);
  EXPECT_EQ(report.by_statics, expected);
  ASSERT_EQ(report.designs.size(), most_targeted);
  const TargetedDesign& first = report.designs.front();
  EXPECT_TRUE(first.is_by_statics());
  EXPECT_FALSE(first.hangs_on_friction());
  EXPECT_TRUE(has_pulls(first.sized.design.routing, 2)) << first.sized.word;
}

// M-1-T-2-F: T1 … T4 = 1, t, t², t³ with t = e^{-μπ}, so that P2/P1 = t².
TEST(Target, ThatOnlyFrictionReachesMovesWithIt) {
  ExploreOptions options = explored(paper_parts(), 2);
  options.generator.parts.joins = parse_joins("T");
  options.constraints = {parse_constraint("sheaths<=1")};
  const double t = std::exp(-0.18 * std::numbers::pi);
  SizingOptions sizing = aiming_at("others=1", 2, {"sheath_angle=4..9"});
  sizing.goal.target = {1 / (1 + t * t), t * t / (1 + t * t)};
  const TargetReport report = target_study(options, sizing, shipped_catalogue());
  EXPECT_EQ(report.by_statics, 0U);
  const TargetedDesign& first = report.designs.front();
  ASSERT_EQ(first.sized.word, "M-1-T-2-F");
  EXPECT_TRUE(first.hangs_on_friction());
  for (std::size_t i = 0; i < friction_factors.size(); ++i) {
    const double moved = std::pow(t, friction_factors.at(i));
    EXPECT_NEAR(first.moved_shares.at(i).at(0), 1 / (1 + moved * moved), 1e-9);
  }
  EXPECT_NEAR(first.static_miss, std::sqrt(2.0) * (1 / (1 + t * t) - 0.5), 1e-9);
}

TEST(Target, IsOutOfReachWhereNothingComesNear) {
  ExploreOptions options = explored(paper_parts(), 2);
  options.constraints = {parse_constraint("sheaths<=1")};
  const TargetReport report = target_study(
      options, aiming_at("1=50,others=1", 2, {"sheath_angle=4..9"}), shipped_catalogue());
  EXPECT_FALSE(report.designs.front().is_met());
  EXPECT_TRUE(misses_target(report));
  EXPECT_FALSE(misses_target(std::nullopt));
}

// Their shares of the carriage are a matter of stiffness.
TEST(Target, IsNotMetByStaticsOfSeveralTendons) {
  ExploreOptions options = explored(paper_parts(), 2);
  options.constraints = {parse_constraint("sheaths==2")};
  const TargetReport report =
      target_study(options, aiming_at("others=1", 2, {"sheath_angle=4..9"}), shipped_catalogue());
  for (const TargetedDesign& design : report.designs) {
    if (design.sized.word.find('+') == std::string::npos) continue;
    EXPECT_TRUE(std::isinf(design.static_miss)) << design.sized.word;
  }
}

// 1x-P-2x halves by statics, but each finger has a sheath of its own. ln T1 - ln T2 is then normal
// with the deviation σ φ √2; to first order √2/4 of it is missed, of which 1.96 is the quantile.
TEST(Target, IsFirstMetByWhatNeedsNoTwoContactsAlike) {
  ExploreOptions options = explored(all_parts(), 2);
  options.constraints = {parse_constraint("blocks<=1"), parse_constraint("sheaths<=2")};
  options.generator.parts.joins = parse_joins("P");
  SizingOptions sizing = aiming_at("others=1", 2, {});
  const TargetReport report = target_study(options, sizing, shipped_catalogue());
  EXPECT_EQ(report.designs.front().sized.word, "M-Y1+1x-Y1-2x");
  EXPECT_LE(report.designs.front().unlike.miss, 1e-4);
  const auto pulley =
      std::find_if(report.designs.begin(), report.designs.end(),
                   [](const TargetedDesign& design) { return design.sized.word == "1x-P-2x"; });
  ASSERT_NE(pulley, report.designs.end());
  EXPECT_TRUE(pulley->is_by_statics());
  const double phi = 0.18 * 2 * std::numbers::pi;
  const double quantile = 1.96 * 0.04 * phi * std::sqrt(2.0) * std::sqrt(2.0) / 4;
  EXPECT_GT(pulley->unlike.miss, 0.6 * quantile);
  EXPECT_LT(pulley->unlike.miss, 1.6 * quantile);
}

TEST(Target, IsTheSameForAnyNumberOfThreads) {
  ExploreOptions options = explored(all_parts(), 2);
  SizingOptions sizing = aiming_at("1=2,others=1", 2, {"sheath_angle=4..9"});
  const TargetReport one = target_study(options, sizing, shipped_catalogue());
  options.threads = sizing.threads = 3;
  const TargetReport three = target_study(options, sizing, shipped_catalogue());
  ASSERT_EQ(one.designs.size(), three.designs.size());
  for (std::size_t i = 0; i < one.designs.size(); ++i) {
    EXPECT_EQ(one.designs[i].sized.word, three.designs[i].sized.word);
    EXPECT_EQ(one.designs[i].moved_shares, three.designs[i].moved_shares);
    EXPECT_EQ(one.designs[i].sized.design.after.goal, three.designs[i].sized.design.after.goal);
  }
}

TEST(Target, ThatIsStoppedIsPartialAndMissesNothing) {
  const std::atomic<bool> stop = true;
  const TargetReport report =
      target_study(explored(all_parts(), 2), aiming_at("1=2,others=1", 2, {"sheath_angle=4..9"}),
                   shipped_catalogue(), {{}, &stop});
  EXPECT_TRUE(report.partial);
  EXPECT_TRUE(report.designs.empty());
  EXPECT_FALSE(misses_target(report));
}

TEST(Friction, IsScaledOfFingersAndContactsToo) {
  Model model;
  model.hardware.fingers.push_back({1, 0.1, {}, 0.3, {}, {}, {}});
  model.hardware.contacts.push_back({"T1", "T2", 0.4, {}});
  model.hardware.block = ContactLaw{0.02, 3};
  const Hardware half = with_friction_times(model, 0.5).hardware;
  EXPECT_EQ(half.tube.mu, 0.09);
  EXPECT_EQ(half.sheath.mu, 0.09);
  EXPECT_EQ(half.bearing.mu, 0.0005);
  EXPECT_EQ(half.block->mu, 0.01);
  EXPECT_EQ(*half.fingers[0].tip_mu, 0.05);
  EXPECT_EQ(*half.fingers[0].sheath_mu, 0.15);
  EXPECT_EQ(*half.contacts[0].mu, 0.2);
}

}  // namespace
}  // namespace reeve::testing
