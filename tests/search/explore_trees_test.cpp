#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "tests/search/generated.hpp"
#include "tests/search/naive_exploration.hpp"

namespace reeve::testing {
namespace {

bool is_among(const std::string& word, const std::vector<RankedDesign>& designs) {
  return std::any_of(designs.begin(), designs.end(),
                     [&](const RankedDesign& entry) { return entry.design.word == word; });
}

// With one sheath instead of four as good as TR7.
TEST(ExploreTrees, ThePulleyAtTheHandIsOnTheFrontBesideTR7) {
  const Objectives with_sheaths{Objective::uniformity_mean, Objective::efficiency_mean,
                                Objective::sheaths};
  const ExploreResult result = explore(options_for(all_parts(), 2, with_sheaths));
  EXPECT_TRUE(is_among("M-Y1+1x-Y1-2x", result.front));
  EXPECT_FALSE(is_among("1-P-2-P-1", result.front));
  EXPECT_EQ(result.total, 480U);
  EXPECT_EQ(result.evaluated, 283U);
  EXPECT_EQ(result.rejected.front().count, 480U - 283U);

  EXPECT_TRUE(is_among("M-Y1+1x-Y1-2x", explore(options_for(all_parts(), 2)).front));
}

TEST(ExploreTrees, AgreesWithANaiveProgram) {
  for (const PartSet& parts : {all_parts(), with_blocks(anchored(paper_parts()), 2)}) {
    for (const Objectives& objectives : several_objectives()) {
      ExploreOptions options = options_for(parts, 2, objectives);
      options.top = 20;
      const Naive naive = naive_program(options);
      const ExploreResult result = explore(options);
      EXPECT_EQ(result.generated, naive.generated);
      EXPECT_EQ(result.evaluated, naive.kept.size());
      const std::vector<RankedDesign> expected = rank(naive.kept, options.order);
      ASSERT_EQ(result.top.size(), options.top);
      for (std::size_t i = 0; i < result.top.size(); ++i) expect_same(result.top[i], expected[i]);
    }
  }
}

TEST(ExploreTrees, GivesTheSameForAnyNumberOfThreads) {
  ExploreOptions options = options_for(all_parts(), 3);
  const ExploreResult one = explore(options);
  for (const int threads : {2, 3, 8}) {
    options.threads = threads;
    const ExploreResult several = explore(options);
    ASSERT_EQ(several.top.size(), one.top.size());
    for (std::size_t i = 0; i < one.top.size(); ++i) expect_same(several.top[i], one.top[i]);
    ASSERT_EQ(several.sample.size(), one.sample.size());
    for (std::size_t i = 0; i < one.sample.size(); ++i) {
      EXPECT_EQ(several.sample[i].word, one.sample[i].word);
    }
  }
}

TEST(ExploreTrees, ShardsTogetherAreTheWhole) {
  ExploreOptions options = options_for(all_parts(), 2);
  const ExploreResult whole = explore(options);
  std::set<std::string> together;
  std::uint64_t evaluated = 0;
  std::uint64_t rejected = 0;
  for (std::uint64_t shard = 1; shard <= 7; ++shard) {
    options.shard = {shard, 7};
    const ExploreResult part = explore(options);
    evaluated += part.evaluated;
    rejected += part.rejected.front().count;
    for (const RankedDesign& entry : part.top) {
      EXPECT_TRUE(together.insert(entry.design.word).second) << entry.design.word;
    }
  }
  EXPECT_EQ(evaluated, whole.evaluated);
  EXPECT_EQ(rejected, whole.rejected.front().count);
  ASSERT_EQ(whole.top.size(), whole.evaluated);
  std::set<std::string> all;
  for (const RankedDesign& entry : whole.top) all.insert(entry.design.word);
  EXPECT_EQ(together, all);
}

// Of the options' references, too: a tree that was generated is found by its word.
TEST(ExploreTrees, AReferenceWithABlockIsFoundAmongTheRoutings) {
  ExploreOptions options = options_for(all_parts(), 2);
  options.references = {canonical(parse_routing("1x-Y1-2x+Y1-M"), FingerIdentity::identical)};
  const ExploreResult result = explore(options);
  EXPECT_TRUE(result.references.front().generated);
  EXPECT_EQ(result.references.front().front, 1);
}

}  // namespace
}  // namespace reeve::testing
