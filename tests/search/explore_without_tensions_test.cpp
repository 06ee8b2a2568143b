// Designs that have no tensions in one of the grasps: left out and counted, and the rest explored.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/mechanics.hpp"
#include "core/tension/tension.hpp"
#include "search/exploration_part.hpp"
#include "tests/search/generated.hpp"
#include "tests/search/same_exploration.hpp"

namespace reeve::testing {
namespace {

bool has_tensions(const Routing& routing, const ExploreOptions& options) {
  const Network network = expand(routing);
  Mechanics mechanics;
  MechanicsBuilder(options.model.hardware).apply(network, mechanics);
  for (const WeightedGrasp& grasp : options.grasps) {
    TensionState state;
    TensionSolver().solve(network, mechanics, grasp.grasp, Direction::pull, state);
    if (!state.in_range) return false;
  }
  return true;
}

// A second motor that gives way: some fingers would have to open.
ExploreOptions against_each_other(const std::string& grasps) {
  ExploreOptions options = options_for(with_motors(with_blocks(anchored(paper_parts()), 1), 2), 2);
  options.grasps = parse_grasps(grasps, 2, 2);
  options.constraints = constraints_of({"efficiency>=0.1", "sheaths<=3"});
  options.top = 20;
  options.keeps_record = true;
  return options;
}

// Some tubes grip harder than any contact may, so that routings with them have no tensions.
ExploreOptions with_a_gripping_tube() {
  ExploreOptions options = options_for(full_parts(), 3);
  options.model.hardware.contacts = {{"T2", "T3", 9, std::nullopt}};
  options.constraints = constraints_of({"sheaths<=2", "efficiency>=0.1"});
  options.keeps_record = true;
  return options;
}

std::vector<std::string> words_without_tensions(const ExploreOptions& options) {
  std::vector<std::string> words;
  for_each_generated(options.generator, [&](const Routing& routing) {
    const bool is_left = is_actuated(routing) && !has_tensions(routing, options);
    if (is_left) words.push_back(to_word(routing));
  });
  return words;
}

std::string first_by_length(std::vector<std::string> words) {
  return *std::min_element(words.begin(), words.end(), [](const auto& a, const auto& b) {
    return std::pair(a.size(), a) < std::pair(b.size(), b);
  });
}

TEST(ExploreWithoutTensions, RanksTheOthersAndCountsThem) {
  for (const char* grasps : {"none@1,-1", "none@1,1/none@1,-1", "1@-1,1", "none@1,0/2@-1,1"}) {
    SCOPED_TRACE(grasps);
    const ExploreOptions options = against_each_other(grasps);
    const std::vector<std::string> words = words_without_tensions(options);
    const ExploreResult result = explore(options);
    EXPECT_EQ(result.without_tensions.count, words.size());
    EXPECT_EQ(result.without_tensions.example, first_by_length(words));
    EXPECT_NE(result.why_without_tensions.find(result.without_tensions.example), std::string::npos);
    EXPECT_EQ(result.evaluated + result.rejected[0].count + words.size(), result.generated);
    const std::set<std::string> left_out(words.begin(), words.end());
    DesignEvaluator evaluator(options.model, options.grasps);
    std::vector<Design> kept;
    for_each_generated(options.generator, [&](const Routing& routing) {
      const std::string word = to_word(routing);
      if (!is_actuated(routing) || left_out.contains(word)) return;
      const ObjectiveValues values = evaluator.evaluate(routing);
      if (first_failure(options.constraints, values) == 0) kept.push_back({word, values});
    });
    const auto ranked = rank(kept, options.order);
    ASSERT_FALSE(ranked.empty());
    ASSERT_EQ(result.top.size(), std::min<std::size_t>(20, ranked.size()));
    for (std::size_t i = 0; i < result.top.size(); ++i) expect_same(result.top[i], ranked[i]);
  }
}

TEST(ExploreWithoutTensions, AreTheSameForAnyThreadsAndShards) {
  for (ExploreOptions options : {against_each_other("none@1,-1"), with_a_gripping_tube()}) {
    const ExploreResult whole = explore(options);
    EXPECT_GT(whole.without_tensions.count, 0U);
    options.threads = 3;
    expect_same_result(explore(options), whole);
    std::vector<ShardRecord> shards;
    for (const std::uint64_t index : {3U, 1U, 2U}) {
      options.shard = {index, 3};
      shards.push_back(*explore(options).record);
    }
    options.shard = {};
    expect_same_result(conclude(shards, options), whole);
  }
}

// Designs that constraints on parts reject are mostly never made, so tensions cannot come first.
TEST(ExploreWithoutTensions, CountAsRejectedByConstraintsOnParts) {
  const ExploreOptions options = with_a_gripping_tube();
  const std::vector<std::string> words = words_without_tensions(options);
  std::set<std::string> left;
  for (const std::string& word : words) {
    const PartCount count = parts(expand(parse_routing(word)));
    if (count.sheaths <= 2) left.insert(word);
  }
  ASSERT_GT(left.size(), 0U);
  ASSERT_LT(left.size(), words.size());
  const ExploreResult pruned = explore(options);
  EXPECT_GT(pruned.pruned, 0U);
  EXPECT_EQ(pruned.without_tensions.count, left.size());
  const std::set<std::string> all(words.begin(), words.end());
  std::uint64_t kept = 0;
  Checkpoint checkpoint;
  checkpoint.design = [&](const EvaluatedDesign& design) {
    EXPECT_FALSE(all.contains(design.word)) << design.word;
    ++kept;
  };
  const ExploreResult made = explore(options, {}, checkpoint);
  expect_same_result(made, pruned);
  EXPECT_EQ(kept + words.size(), made.evaluated + made.without_tensions.count);
}

TEST(ExploreWithoutTensions, MayBeAll) {
  ExploreOptions options = options_for(paper_parts(), 1);
  options.generator.parts.joins = {};
  options.model.hardware.contacts = {{"T1", "T2", 9, std::nullopt}};
  const ExploreResult result = explore(options);
  EXPECT_EQ(result.evaluated, 0U);
  EXPECT_GT(result.without_tensions.count, 0U);
  EXPECT_TRUE(result.top.empty());
}

}  // namespace
}  // namespace reeve::testing
