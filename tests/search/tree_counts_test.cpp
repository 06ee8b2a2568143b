#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tests/search/counted_trees.hpp"
#include "tests/search/generated.hpp"
#include "tests/support/sanitizers.hpp"

namespace reeve::testing {
namespace {

struct Row {
  PartSet parts;
  int blocks;
  std::vector<std::uint64_t> all;  // by fingers
  std::vector<std::uint64_t> actuated;
};

TEST(TreeCounts, TableOfAnchoredTipsAndBlocks) {
  const PartSet paper = anchored(paper_parts());
  const PartSet full = anchored(full_parts());
  const std::vector<Row> table{
      {paper, 0, {7, 43, 214, 973, 4059}, {4, 21, 85, 339, 1239}},
      {paper, 1, {7, 90, 735, 4740, 26317}, {7, 63, 416, 2264, 10938}},
      {paper, 2, {14, 243, 2522, 20044, 133527}, {14, 195, 1671, 11374, 66258}},
      {full, 0, {14, 168, 1738, 16763, 153390}, {7, 70, 612, 5328, 44840}},
      {full, 1, {12, 312, 5364, 74895, 920517}, {12, 213, 2943, 35133, 383106}},
      {full, 2, {24, 810, 17280, 292182, 4259973}, {24, 627, 11088, 162574, 2111942}},
      {full, 3, {48, 2046, 52690, 1044146, 17497974}, {48, 1695, 37346, 650255, 9774126}},
  };
  for (const Row& row : table) {
    for (int fingers = 1; fingers <= 5; ++fingers) {
      const RoutingNumbers counts = exactly(row.parts, row.blocks, fingers, identical);
      const auto column = static_cast<std::size_t>(fingers - 1);
      EXPECT_EQ(counts[0], row.all[column]) << row.blocks << " blocks, " << fingers;
      EXPECT_EQ(counts[1], row.actuated[column]) << row.blocks << " blocks, " << fingers;
    }
  }
}

TEST(TreeCounts, TableOfSingleTrees) {
  const std::vector<std::vector<std::uint64_t>> table{{12, 129, 1200, 10359, 83709},
                                                      {24, 381, 4647, 49606, 483667}};
  for (int blocks = 1; blocks <= 2; ++blocks) {
    for (int fingers = 1; fingers <= 5; ++fingers) {
      EXPECT_EQ(exactly(anchored(full_parts()), blocks, fingers, identical)[2],
                table[static_cast<std::size_t>(blocks - 1)][static_cast<std::size_t>(fingers - 1)]);
    }
  }
}

std::vector<PartSet> various_parts() {
  std::vector<PartSet> sets = odd_parts();
  sets.push_back(paper_parts());
  sets.push_back(full_parts());
  const std::size_t many = sets.size();
  for (std::size_t i = 0; i < many; ++i) sets.push_back(anchored(sets[i]));
  for (std::size_t i = 0; i < 2 * many; ++i) sets.push_back(linked(sets[i]));
  for (std::size_t i = 0; i < 4 * many; ++i) sets.push_back(in_series(sets[i]));
  for (std::size_t i = 0; i < many; ++i) sets.push_back(barred(sets[i]));
  for (std::size_t i = 7 * many; i < 8 * many; ++i) sets.push_back(barred(sets[i]));
  return sets;
}

std::vector<PartSet> parts_with_sheaves() {
  std::vector<PartSet> sets;
  for (const PartSet& parts : various_parts()) {
    if (parts.linked && !parts.series) continue;
    sets.push_back(becketed(parts));
    sets.push_back(passed_twice(parts));
    sets.push_back(becketed(passed_twice(parts)));
  }
  return sets;
}

void expect_power_series(const std::vector<PartSet>& sets, int most_fingers) {
  for (const PartSet& parts : sets) {
    for (const FingerIdentity identity : {identical, distinct}) {
      for (int fingers = 1; fingers <= most_fingers; ++fingers) {
        for (int blocks = 0; blocks <= 4; ++blocks) {
          EXPECT_EQ(exactly(parts, blocks, fingers, identity),
                    numbers_of(count_trees(counted_with_trees(parts), fingers, blocks,
                                           identity == identical)))
              << label_of(generating(with_blocks(parts, blocks), fingers, identity));
        }
      }
    }
  }
}

TEST(TreeCounts, AreThoseOfThePowerSeries) { expect_power_series(various_parts(), 6); }

TEST(TreeCounts, OfBecketsAndDoublePassesAreThoseOfThePowerSeries) {
  expect_power_series(parts_with_sheaves(), 4);
}

TEST(TreeCounts, AreThoseOfBruteForce) {
  for (const FingerIdentity identity : {identical, distinct}) {
    for (const PartSet& parts : various_parts()) {
      for (int blocks = 0; blocks <= 1; ++blocks) {
        for (int fingers = 1; fingers <= 2; ++fingers) {
          expect_brute_force_trees(parts, fingers, blocks, identity);
        }
      }
      expect_brute_force_trees(parts, 1, 2, identity);
    }
    for (const PartSet& parts : parts_with_sheaves())
      expect_brute_force_trees(parts, 2, 1, identity);
  }
  // The larger ones, with fingers of one kind and of the other in turn.
  FingerIdentity identity = identical;
  for (const PartSet& parts : various_parts()) {
    expect_brute_force_trees(parts, 2, 2, identity);
    identity = identity == identical ? distinct : identical;
  }
}

TEST(TreeCounts, OfJoinsBesideEndsAreThoseOfBruteForce) {
  SKIP_UNDER_SANITIZERS();
  for (const FingerIdentity identity : {identical, distinct}) {
    for (const char* joins : {"P", "T,P"}) {
      for (const PartSet& parts :
           {anchored(paper_parts()), parts_of("tube", "P", "F"), parts_of("tube", "", "M"),
            anchored(parts_of("tube", "T", ""))}) {
        for (int blocks = 0; blocks <= 1; ++blocks) {
          const PartSet beside = with_beside(parts, joins);
          expect_brute_force_trees(beside, 1, blocks, identity);
          if (beside.beside.size() == 1) expect_brute_force_trees(beside, 2, blocks, identity);
        }
      }
    }
    const PartSet of_two_motors =
        with_motors(with_beside(anchored(parts_of("tube", "P", "F")), "P"), 2);
    for (int blocks = 0; blocks <= 1; ++blocks) {
      expect_brute_force_trees(of_two_motors, 2, blocks, identity);
    }
  }
  // Larger ones, each with fingers of one kind.
  expect_brute_force_trees(with_beside(parts_of("tube", "T", "M,F"), "P"), 2, 2, identical);
  expect_brute_force_trees(linked(with_beside(parts_of("tube", "", "M,F"), "P")), 2, 2, distinct);
  expect_brute_force_trees(with_beside(anchored(parts_of("tube", "", "F")), "P"), 3, 2, identical);
}

TEST(TreeCounts, OfThreeBlocksInSeriesAndBarsAreThoseOfBruteForce) {
  for (const FingerIdentity identity : {identical, distinct}) {
    for (const PartSet& parts : {parts_of("tube", "", "M"), parts_of("tube", "", "F")}) {
      expect_brute_force_trees(in_series(anchored(parts)), 3, 3, identity);
      expect_brute_force_trees(linked(in_series(parts)), 3, 3, identity);
    }
    expect_brute_force_trees(in_series(anchored(parts_of("tube", "P", ""))), 3, 3, identity);
    expect_brute_force_trees(with_motors(barred(anchored(parts_of("tube", "P", "M"))), 2), 2, 2,
                             identity);
    expect_brute_force_trees(with_motors(in_series(anchored(parts_of("tube", "P", "M"))), 2), 2, 2,
                             identity);
  }
  expect_brute_force_trees(barred(in_series(anchored(parts_of("tube", "", "M")))), 3, 3, identical);
}

TEST(TreeCounts, OfBecketsAndDoublePassesAreThoseOfBruteForce) {
  for (const FingerIdentity identity : {identical, distinct}) {
    for (const char* joins : {"", "P"}) {
      const PartSet few = anchored(parts_of("tube", joins, "M"));
      expect_brute_force_trees(becketed(few), 3, 1, identity);
      expect_brute_force_trees(passed_twice(few), 3, 1, identity);
      expect_brute_force_trees(becketed(passed_twice(few)), 3, 1, identity);
    }
    const PartSet few = parts_of("tube", "", "M");
    expect_brute_force_trees(becketed(few), 2, 2, identity);
    expect_brute_force_trees(passed_twice(few), 3, 2, identity);
    expect_brute_force_trees(barred(in_series(passed_twice(few))), 2, 2, identity);
    const PartSet of_two_motors = with_motors(anchored(parts_of("tube", "P", "M")), 2);
    expect_brute_force_trees(becketed(passed_twice(of_two_motors)), 2, 1, identity);
    expect_brute_force_trees(becketed(passed_twice(with_beside(few, "P"))), 2, 1, identity);
  }
}

TEST(TreeCounts, OfThreeFingersAreThoseOfBruteForce) {
  expect_brute_force_trees(anchored(paper_parts()), 3, 0, distinct);
  expect_brute_force_trees(anchored(paper_parts()), 3, 1, distinct);
  expect_brute_force_trees(linked(in_series(anchored(paper_parts()))), 3, 2, identical);
  expect_brute_force_trees(anchored(full_parts()), 3, 1, identical);
}

}  // namespace
}  // namespace reeve::testing
