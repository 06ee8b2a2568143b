#include <gtest/gtest.h>

#include <cstdint>

#include "search/enumerate/generator.hpp"

namespace reeve {
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

}  // namespace
}  // namespace reeve
