// Two floating blocks on three fingers, and two motors on four, by every way to tie their parts
// together.
#include <gtest/gtest.h>

#include "search/enumerate/counting.hpp"
#include "tests/search/counted_parts.hpp"
#include "tests/support/brute_force.hpp"

namespace reeve::testing {
namespace {

void expect_brute_force(PartSet parts, FingerIdentity identity) {
  parts.anchored = true;
  const auto expected =
      brute_force_trees(counted_with_trees(parts), 3, 2, identity == FingerIdentity::identical);
  parts.blocks = 2;
  const auto up_to_two = count_routings(parts, 3, identity);
  parts.blocks = 1;
  const auto up_to_one = count_routings(parts, 3, identity);
  EXPECT_EQ(up_to_two.all - up_to_one.all, expected.all);
  EXPECT_EQ(up_to_two.actuated - up_to_one.actuated, expected.actuated);
  EXPECT_EQ(up_to_two.one_tendon - up_to_one.one_tendon, expected.one_tendon);
}

TEST(TreeCountsOfThreeFingersAndTwoBlocks, AreThoseOfBruteForce) {
  expect_brute_force(full_parts(), FingerIdentity::identical);
  expect_brute_force(paper_parts(), FingerIdentity::distinct);
}

TEST(MotorCountsOfFourFingers, AreThoseOfBruteForce) {
  PartSet parts = paper_parts();
  parts.motors = 2;
  const auto expected = brute_force_trees(counted_with_trees(parts), 4, 0, true);
  const auto counts = count_routings(parts, 4, FingerIdentity::identical);
  EXPECT_EQ(counts.all, expected.all);
  EXPECT_EQ(counts.actuated, expected.actuated);
  EXPECT_EQ(counts.one_tendon, expected.one_tendon);
}

}  // namespace
}  // namespace reeve::testing
