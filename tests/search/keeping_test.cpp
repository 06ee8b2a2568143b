// An exploration that goes on from what was saved of another one ends as that one.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "search/exploration_part.hpp"
#include "search/explore.hpp"
#include "search/judge/evaluation.hpp"
#include "tests/search/generated.hpp"

namespace reeve::testing {
namespace {

ExploreOptions kept_options(int threads) {
  ExploreOptions options;
  options.generator.fingers = 5;
  options.generator.parts = full_parts();
  options.grasps = single_grasps(5);
  options.top = 20;
  options.sample = 50;
  options.threads = threads;
  options.constraints = {parse_constraint("sheaths<=4"), parse_constraint("jams<=3")};
  options.references = {parse_routing("M-1-T-2-T-3-T-4-T-5-F")};
  options.keeps_record = true;
  return options;
}

void expect_same(const ExploreResult& a, const ExploreResult& b) {
  EXPECT_EQ(a.generated, b.generated);
  EXPECT_EQ(a.evaluated, b.evaluated);
  EXPECT_EQ(a.unconverged, b.unconverged);
  for (std::size_t i = 0; i < b.rejected.size(); ++i) {
    EXPECT_EQ(a.rejected[i].count, b.rejected[i].count);
  }
  EXPECT_EQ(a.references[0].dominated_by, b.references[0].dominated_by);
  EXPECT_EQ(a.references[0].generated, b.references[0].generated);
  ASSERT_EQ(a.top.size(), b.top.size());
  for (std::size_t i = 0; i < b.top.size(); ++i) {
    EXPECT_EQ(a.top[i].design.word, b.top[i].design.word);
    EXPECT_EQ(a.top[i].design.values, b.top[i].design.values);
  }
  ASSERT_EQ(a.sample.size(), b.sample.size());
  for (std::size_t i = 0; i < b.sample.size(); ++i) EXPECT_EQ(a.sample[i].word, b.sample[i].word);
  EXPECT_EQ(a.front_equals_left_out, b.front_equals_left_out);
}

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
