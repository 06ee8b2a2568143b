// Floating blocks on three and four fingers, and two motors on four, by every way to tie their
// parts together.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "tests/search/counted_trees.hpp"

namespace reeve::testing {
namespace {

void expect_generated(const PartSet& parts, int fingers, FingerIdentity identity) {
  std::set<std::string> words;
  for_each_generated(generating(parts, fingers, identity),
                     [&](const Routing& routing) { words.insert(to_word(routing)); });
  EXPECT_EQ(words.size(), count_routings(parts, fingers, identity).all);
}

TEST(TreeCountsOfThreeFingersAndTwoBlocks, AreThoseOfBruteForce) {
  expect_brute_force_trees(anchored(full_parts()), 3, 2, identical);
  expect_brute_force_trees(anchored(paper_parts()), 3, 2, distinct);
}

TEST(MotorCountsOfFourFingers, AreThoseOfBruteForce) {
  expect_brute_force_trees(with_motors(paper_parts(), 2), 4, 0, identical);
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
        for (const int blocks : {0, 1}) expect_brute_force_trees(switched, 4, blocks, identical);
        expect_generated(with_blocks(switched, 2), 4, identical);
      }
    }
  }
}

TEST(TreeCountsOfFourFingers, OfTwoBlocksAndOfJoinsBesideEndsAreThoseOfBruteForce) {
  for (const PartSet& parts : few_parts()) {
    for (const PartSet& switched : {linked(parts), in_series(parts), barred(parts)}) {
      expect_brute_force_trees(switched, 4, 2, identical);
    }
    for (const int blocks : {0, 1}) {
      expect_brute_force_trees(with_beside(parts, "P"), 4, blocks, identical);
    }
    expect_generated(with_blocks(with_beside(parts, "P"), 1), 4, identical);
  }
  expect_brute_force_trees(becketed(few_parts()[0]), 4, 2, identical);
  expect_brute_force_trees(passed_twice(few_parts()[0]), 4, 2, identical);
}

}  // namespace
}  // namespace reeve::testing
