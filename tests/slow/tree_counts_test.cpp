// Floating blocks on three and four fingers, and two motors on four, by every way to tie their
// parts together.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "search/enumerate/counting.hpp"
#include "tests/search/counted_parts.hpp"
#include "tests/search/generated.hpp"
#include "tests/support/brute_force.hpp"

namespace reeve::testing {
namespace {

// With exactly so many blocks, as the difference to fewer.
void expect_brute_force(const PartSet& parts, int fingers, int blocks, FingerIdentity identity) {
  RoutingNumbers counts = numbers_of(count_routings(with_blocks(parts, blocks), fingers, identity));
  if (blocks > 0) {
    const RoutingNumbers fewer =
        numbers_of(count_routings(with_blocks(parts, blocks - 1), fingers, identity));
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] -= fewer[i];
  }
  EXPECT_EQ(counts, numbers_of(brute_force_trees(counted_with_trees(parts), fingers, blocks,
                                                 identity == identical)))
      << label_of(generating(with_blocks(parts, blocks), fingers, identity));
}

void expect_generated(const PartSet& parts, int fingers, FingerIdentity identity) {
  std::set<std::string> words;
  for_each_generated(generating(parts, fingers, identity),
                     [&](const Routing& routing) { words.insert(to_word(routing)); });
  EXPECT_EQ(words.size(), count_routings(parts, fingers, identity).all);
}

TEST(TreeCountsOfThreeFingersAndTwoBlocks, AreThoseOfBruteForce) {
  expect_brute_force(anchored(full_parts()), 3, 2, identical);
  expect_brute_force(anchored(paper_parts()), 3, 2, distinct);
}

TEST(MotorCountsOfFourFingers, AreThoseOfBruteForce) {
  expect_brute_force(with_motors(paper_parts(), 2), 4, 0, identical);
}

std::vector<PartSet> few_parts() {
  const PartSet few = parts_of("tube", "", "M");
  return {few, anchored(few), parts_of("tube", "P", "M")};
}

TEST(TreeCountsOfFourFingers, AreThoseOfBruteForceWithEachSwitchAndOneOrTwoMotors) {
  for (const int motors : {1, 2}) {
    for (const PartSet& one_motor : few_parts()) {
      const PartSet parts = with_motors(one_motor, motors);
      for (const PartSet& switched : {parts, linked(parts), in_series(parts), barred(parts),
                                      becketed(parts), passed_twice(parts)}) {
        for (const int blocks : {0, 1}) expect_brute_force(switched, 4, blocks, identical);
        expect_generated(with_blocks(switched, 2), 4, identical);
      }
    }
  }
}

TEST(TreeCountsOfFourFingers, OfTwoBlocksAndOfJoinsBesideEndsAreThoseOfBruteForce) {
  for (const PartSet& parts : few_parts()) {
    for (const PartSet& switched : {linked(parts), in_series(parts), barred(parts)}) {
      expect_brute_force(switched, 4, 2, identical);
    }
    for (const int blocks : {0, 1}) {
      expect_brute_force(with_beside(parts, "P"), 4, blocks, identical);
    }
    expect_generated(with_blocks(with_beside(parts, "P"), 1), 4, identical);
  }
  expect_brute_force(becketed(few_parts()[0]), 4, 2, identical);
  expect_brute_force(passed_twice(few_parts()[0]), 4, 2, identical);
}

}  // namespace
}  // namespace reeve::testing
