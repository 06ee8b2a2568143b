#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "search/enumerate/generator.hpp"
#include "tests/search/generated.hpp"

namespace reeve::testing {
namespace {

TEST(Shards, RangesPartitionTheWhole) {
  for (const std::uint64_t total :
       {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2}, std::uint64_t{94},
        std::uint64_t{9942}, (std::uint64_t{1} << 63) - 1}) {
    for (const std::uint64_t n : {1U, 2U, 3U, 7U, 64U, 95U, 1000U}) {
      std::uint64_t end = 0;
      for (std::uint64_t i = 1; i <= n; ++i) {
        const ShardRange range = shard_range(total, i, n);
        ASSERT_EQ(range.begin, end) << i << "/" << n << " of " << total;
        ASSERT_LE(range.begin, range.end);
        const std::uint64_t size = range.end - range.begin;
        ASSERT_TRUE(size == total / n || size == total / n + 1) << i << "/" << n << " of " << total;
        end = range.end;
      }
      ASSERT_EQ(end, total) << n;
    }
  }
}

TEST(Shards, AsManyShardsAsANumberCanSay) {
  const std::uint64_t n = ~std::uint64_t{0};
  EXPECT_EQ(shard_range(10, 1, n).begin, 0U);
  EXPECT_EQ(shard_range(10, n, n).end, 10U);
  EXPECT_EQ(shard_range(10, n / 2, n).end, shard_range(10, n / 2 + 1, n).begin);
}

void expect_shards_make_the_whole(const GeneratorOptions& o, std::uint64_t n) {
  std::vector<std::string> together;
  for (std::uint64_t i = 1; i <= n; ++i) {
    RoutingGenerator generator(o);
    const ShardRange range = shard_range(generator.total(), i, n);
    generator.seek(range.begin);
    Routing routing;
    for (std::uint64_t index = range.begin; index < range.end; ++index) {
      ASSERT_TRUE(generator.next(routing)) << i << "/" << n;
      together.push_back(to_word(routing));
    }
  }
  EXPECT_EQ(together, generated_words(o)) << label_of(o) << ", " << n << " shards";
}

TEST(Shards, ShardsTogetherAreTheWhole) {
  for (const std::uint64_t n : {1U, 2U, 3U, 7U, 100U, 1500U}) {
    expect_shards_make_the_whole(generating(full_parts(), 3, identical), n);
    expect_shards_make_the_whole(generating(full_parts(), 3, identical, true), n);
    expect_shards_make_the_whole(generating(full_parts(), 2, distinct), n);
    expect_shards_make_the_whole(generating(paper_parts(), 4, distinct), n);
    expect_shards_make_the_whole(generating(all_parts(), 2, identical), n);
    expect_shards_make_the_whole(generating(all_parts(), 2, distinct), n);
    expect_shards_make_the_whole(generating(with_blocks(paper_parts(), 2), 3, identical), n);
  }
  expect_shards_make_the_whole(generating(full_parts(), 5, identical), 11);
}

}  // namespace
}  // namespace reeve::testing
