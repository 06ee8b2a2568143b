// An exploration that goes on from what was saved of another one ends as that one.
#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <vector>

#include "search/evaluate/evaluation.hpp"
#include "search/exploration_part.hpp"
#include "search/explore.hpp"
#include "tests/search/kept_exploration.hpp"

namespace reeve::testing {
namespace {

TEST(ExploreCheckpoint, GoesOnFromEverySaveToTheSameResult) {
  const ExploreResult whole = explore(kept_options(2));
  std::vector<ShardRecord> saved;
  Checkpoint checkpoint;
  checkpoint.is_due = [] { return true; };
  DesignEvaluator evaluator({}, kept_options(1).grasps, kept_options(1).score);
  checkpoint.save = [&](ExplorationPart& part) {
    saved.push_back(record_of(part));
    for (const ArchivedDesign& kept : part.archive.members()) {
      ASSERT_EQ(kept.design.values, evaluator.evaluate(parse_routing(kept.design.word)));
    }
  };
  expect_same(explore(kept_options(1), {}, checkpoint), whole);
  ASSERT_GT(saved.size(), 5U);
  for (const std::size_t i : {std::size_t{0}, std::size_t{3}, saved.size() - 1}) {
    SCOPED_TRACE(i);
    Checkpoint later;
    later.before = saved[i];
    expect_same(explore(kept_options(2), {}, later), whole);
  }
}

// Whether or not they are among the best, or meet the constraints.
TEST(ExploreCheckpoint, GivesEveryDesignOnceInFull) {
  ExploreOptions options = kept_options(2);
  std::map<std::uint64_t, EvaluatedDesign> designs;
  Checkpoint checkpoint;
  checkpoint.design = [&](const EvaluatedDesign& design) {
    EXPECT_TRUE(designs.empty() || designs.rbegin()->first < design.place);
    designs.emplace(design.place, design);
  };
  const ExploreResult result = explore(options, {}, checkpoint);
  EXPECT_EQ(designs.size(), result.evaluated);
  RoutingGenerator generator(options.generator);
  DesignEvaluator evaluator(options.model, options.grasps, options.score);
  Routing routing;
  for (const std::uint64_t place : {designs.begin()->first, designs.rbegin()->first}) {
    generator.seek(place);
    generator.next(routing);
    EXPECT_EQ(designs.at(place).word, to_word(routing));
    EXPECT_EQ(designs.at(place).values, evaluator.evaluate(routing));
  }
}

// The beginning of a shard is found step by step, which may take minutes.
TEST(ExploreCheckpoint, StoppedOnTheWayToItsBeginningHasNothingYetAndGoesOn) {
  ExploreOptions options = kept_options(2);
  options.generator.fingers = 8;
  options.grasps = single_grasps(8);
  options.constraints = {parse_constraint("sheaths<=3")};
  options.references.clear();
  options.shard = {2, 20};
  const std::atomic<bool> stop = true;
  std::vector<ShardRecord> saved;
  Checkpoint checkpoint;
  checkpoint.save = [&](ExplorationPart& part) { saved.push_back(record_of(part)); };
  const ExploreResult stopped = explore(options, {{}, &stop}, checkpoint);
  EXPECT_TRUE(stopped.partial);
  EXPECT_EQ(stopped.generated, 0U);
  EXPECT_GT(stopped.total, 1'000'000U);
  ASSERT_EQ(saved.size(), 1U);
  Checkpoint later;
  later.before = saved[0];
  const ExploreResult whole = explore(options);
  const ExploreResult gone_on = explore(options, {}, later);
  EXPECT_EQ(gone_on.generated, whole.generated);
  EXPECT_EQ(gone_on.evaluated, whole.evaluated);
  ASSERT_FALSE(whole.top.empty());
  ASSERT_EQ(gone_on.top.size(), whole.top.size());
  EXPECT_EQ(gone_on.top.back().design.word, whole.top.back().design.word);
  EXPECT_EQ(gone_on.rejected.back().count, whole.rejected.back().count);
}

}  // namespace
}  // namespace reeve::testing
