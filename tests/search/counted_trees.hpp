// Numbers of routings with a given number of blocks, against every way to tie their parts together.
#pragma once

#include <gtest/gtest.h>

#include "search/enumerate/counting.hpp"
#include "tests/search/counted_parts.hpp"
#include "tests/search/generated.hpp"
#include "tests/support/brute_force.hpp"

namespace reeve::testing {

// With exactly so many blocks, as the difference to fewer.
inline RoutingNumbers exactly(PartSet parts, int blocks, int fingers, FingerIdentity identity) {
  parts.blocks = blocks;
  RoutingNumbers counts = numbers_of(count_routings(parts, fingers, identity));
  if (blocks == 0) return counts;
  parts.blocks = blocks - 1;
  const RoutingNumbers fewer = numbers_of(count_routings(parts, fingers, identity));
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] -= fewer[i];
  return counts;
}

inline void expect_brute_force_trees(const PartSet& parts, int fingers, int blocks,
                                     FingerIdentity identity) {
  EXPECT_EQ(exactly(parts, blocks, fingers, identity),
            numbers_of(brute_force_trees(counted_with_trees(parts), fingers, blocks,
                                         identity == identical)))
      << label_of(generating(with_blocks(parts, blocks), fingers, identity));
}

}  // namespace reeve::testing
