// An exploration that goes on from what was saved of another one ends as that one.
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "search/exploration_part.hpp"
#include "search/explore.hpp"
#include "search/judge/evaluation.hpp"
#include "tests/search/kept_exploration.hpp"

namespace reeve::testing {
namespace {

TEST(ExploreKeeping, GoesOnFromEverySaveToTheSameResult) {
  const ExploreResult whole = explore(kept_options(2));
  std::vector<ShardRecord> saved;
  Keeping keeping;
  keeping.is_due = [] { return true; };
  DesignEvaluator evaluator({}, kept_options(1).grasps, kept_options(1).score);
  keeping.save = [&](ExplorationPart& part) {
    saved.push_back(record_of(part));
    for (const ArchivedDesign& kept : part.archive.members()) {
      ASSERT_EQ(kept.design.values, evaluator.evaluate(parse_routing(kept.design.word)));
    }
  };
  expect_same(explore(kept_options(1), {}, keeping), whole);
  ASSERT_GT(saved.size(), 5U);
  for (const std::size_t i : {std::size_t{0}, std::size_t{3}, saved.size() - 1}) {
    SCOPED_TRACE(i);
    Keeping later;
    later.before = saved[i];
    expect_same(explore(kept_options(2), {}, later), whole);
  }
}

// Whether or not they are among the best, or meet the constraints.
TEST(ExploreKeeping, GivesEveryDesignOnceInFull) {
  ExploreOptions options = kept_options(2);
  std::map<std::uint64_t, EvaluatedDesign> designs;
  Keeping keeping;
  keeping.design = [&](const EvaluatedDesign& design) {
    EXPECT_TRUE(designs.empty() || designs.rbegin()->first < design.place);
    designs.emplace(design.place, design);
  };
  const ExploreResult result = explore(options, {}, keeping);
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

}  // namespace
}  // namespace reeve::testing
