#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "search/exploration_part.hpp"
#include "search/explore.hpp"
#include "tests/search/same_exploration.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/sanitizers.hpp"

namespace reeve::testing {
namespace {

TEST(ExploreThreads, DoNotChangeTheResult) {
  ExploreOptions one_batch = options_for(full_parts(), 3, several_objectives()[3]);
  one_batch.top = 15;
  one_batch.sample = 100;
  one_batch.constraints = {parse_constraint("jams==0"), parse_constraint("sheaths<=4")};
  one_batch.references = {parse_routing("1-P-2-P-3-P-1"), parse_routing("M-1-T-2-T-3-F")};
  ExploreOptions batches = several_batches();
  batches.references = {parse_routing("M-1-T-2-T-3-T-4-T-5-F")};
  ExploreOptions unmet = several_batches();
  unmet.constraints = {parse_constraint("sheaths<=1"), parse_constraint("uniformity>=0.98")};
  for (ExploreOptions options : {one_batch, batches, unmet, options_for(all_parts(), 3)}) {
    const ExploreResult one = explore(options);
    for (const int threads : has_sanitizer() ? std::vector{3} : std::vector{2, 3, 8}) {
      SCOPED_TRACE(threads);
      options.threads = threads;
      expect_same_result(explore(options), one);
    }
  }
}

void expect_shards_make_the_whole(ExploreOptions options, std::uint64_t count) {
  const ExploreResult whole = explore(options);
  std::uint64_t total = 0;
  std::uint64_t generated = 0;
  std::uint64_t evaluated = 0;
  std::vector<std::uint64_t> rejected(whole.rejected.size(), 0);
  std::set<std::string> tops;
  for (std::uint64_t index = 1; index <= count; ++index) {
    options.shard = {index, count};
    const ExploreResult part = explore(options);
    EXPECT_FALSE(part.partial) << index << " of " << count;
    total += part.total;
    generated += part.generated;
    evaluated += part.evaluated;
    for (std::size_t r = 0; r < rejected.size(); ++r) rejected[r] += part.rejected[r].count;
    for (const RankedDesign& entry : part.top) {
      EXPECT_TRUE(tops.insert(entry.design.word).second) << entry.design.word;
    }
  }
  EXPECT_EQ(total, whole.total);
  EXPECT_EQ(generated, whole.generated);
  EXPECT_EQ(evaluated, whole.evaluated);
  for (std::size_t r = 0; r < rejected.size(); ++r) EXPECT_EQ(rejected[r], whole.rejected[r].count);
  for (const RankedDesign& entry : whole.top) {
    EXPECT_EQ(tops.count(entry.design.word), 1U) << entry.design.word << " of " << count;
  }
}

TEST(ExploreShards, TogetherAreTheWhole) {
  ExploreOptions options = options_for(full_parts(), 3);
  options.top = 12;
  options.constraints = {parse_constraint("jams==0")};
  for (const std::uint64_t count : {1U, 2U, 3U, 7U, 50U}) {
    expect_shards_make_the_whole(options, count);
  }
  expect_shards_make_the_whole(options_for(all_parts(), 2), 7);
}

TEST(ExploreShards, MayBeEmpty) {
  ExploreOptions options = options_for(paper_parts(), 1);
  options.shard = {1, 1000};
  const ExploreResult result = explore(options);
  EXPECT_EQ(result.total, 0U);
  EXPECT_EQ(result.evaluated, 0U);
  EXPECT_FALSE(result.partial);
  EXPECT_TRUE(result.top.empty());
  EXPECT_TRUE(result.front.empty());
}

TEST(ParseShard, ReadsPartAndNumberOfParts) {
  EXPECT_EQ(parse_shard("1/1").count, 1U);
  const Shard other = parse_shard("3/64");
  EXPECT_EQ(other.index, 3U);
  EXPECT_EQ(other.count, 64U);
}

TEST(ParseShardError, SaysWhatAShardIs) {
  for (const std::string& text : comma_separated(
           "3/2,0/4,a/b,1/,,1/0,-1/2,1/2/3,/,/2,1,1/-2,1/b, 1/2,1 /2,1/2 ,1.5/2,+1/2,0/0,"
           "99999999999999999999/2,1/99999999999999999999")) {
    EXPECT_EQ(input_error([&] { parse_shard(text); }),
              "shard '" + text + "': expected i/N with 1 <= i <= N, such as 2/8");
  }
}

TEST(Shards, WordsThatAreNoRoutingsAreOfTheirFile) {
  const ExploreOptions options = options_for(full_parts(), 2, several_objectives()[0]);
  ShardRecord record;
  record.origin = "s1/shard.json";
  record.archive = {{"1-Q", 0}};
  const auto error = [&] {
    return input_error([&] { conclude(std::vector<ShardRecord>{record}, options); });
  };
  EXPECT_EQ(error().substr(0, 35), "s1/shard.json: routing '1-Q', colum");
  record.archive = {{"M-1-F", 0}};
  EXPECT_EQ(error(),
            "s1/shard.json: routing 'M-1-F': expected one of 2 fingers that the motor pulls");
}

}  // namespace
}  // namespace reeve::testing
