#include <gtest/gtest.h>

#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "search/enumerate/counting.hpp"
#include "search/enumerate/generator.hpp"
#include "tests/search/counted_parts.hpp"
#include "tests/search/generated.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/counting.hpp"

namespace reeve::testing {
namespace {

using Counts = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>;

Counts generated_counts(const GeneratorOptions& o) {
  std::uint64_t all = 0;
  std::uint64_t actuated = 0;
  std::uint64_t one_tendon = 0;
  RoutingGenerator generator(o);
  Routing routing;
  while (generator.next(routing)) {
    ++all;
    if (!is_actuated(routing)) continue;
    ++actuated;
    if (routing.tendons.size() == 1) ++one_tendon;
  }
  EXPECT_EQ(generator.total(), all);
  return {all, actuated, one_tendon};
}

Counts formula_counts(const GeneratorOptions& o) {
  const auto c = count_trees({counted(o.parts)}, o.fingers, 0, o.identity == identical);
  return {c.all, c.actuated, c.one_tendon};
}

Counts brute_force_counts(const GeneratorOptions& o) {
  const auto c = brute_force_trees({counted(o.parts)}, o.fingers, 0, o.identity == identical);
  return {c.all, c.actuated, c.one_tendon};
}

TEST(Generator, CountsOfPaperAndFullPartsAreThoseOfTheTable) {
  const std::vector<Counts> paper{{5, 3, 3}, {24, 13, 7}, {94, 43, 12}, {346, 145, 24}};
  const std::vector<Counts> full{{12, 6, 6}, {126, 54, 33}, {1152, 426, 172}, {9942, 3402, 990}};
  for (const auto& [parts, table] : {std::pair{paper_parts(), paper}, {full_parts(), full}}) {
    for (int fingers = 1; fingers <= 4; ++fingers) {
      const Counts& expected = table[static_cast<std::size_t>(fingers - 1)];
      const auto counts = count_routings(parts, fingers, identical);
      EXPECT_EQ(Counts(counts.all, counts.actuated, counts.one_tendon), expected);
      EXPECT_EQ(generated_counts(generating(parts, fingers, identical)), expected);
    }
  }
}

void expect_formula(const PartSet& parts, int most, FingerIdentity identity) {
  for (int fingers = 1; fingers <= most; ++fingers) {
    const GeneratorOptions o = generating(parts, fingers, identity);
    EXPECT_EQ(generated_counts(o), formula_counts(o)) << label_of(o);
  }
}

TEST(Generator, CountsOfIdenticalFingersAreThoseOfTheFormulas) {
  expect_formula(paper_parts(), 8, identical);
  expect_formula(full_parts(), 6, identical);
}

TEST(Generator, CountsOfDistinctFingersAreThoseOfTheFormulas) {
  expect_formula(paper_parts(), 6, distinct);
  expect_formula(full_parts(), 4, distinct);
}

TEST(Generator, CountsOfOddPartsAreThoseOfTheFormulas) {
  for (const PartSet& parts : odd_parts()) {
    expect_formula(parts, 5, identical);
    expect_formula(parts, 4, distinct);
  }
}

TEST(Generator, TotalsOfMoreFingersAreThoseOfTheFormulas) {
  for (const PartSet& parts : {paper_parts(), full_parts()}) {
    for (int fingers = 1; fingers <= 12; ++fingers) {
      const GeneratorOptions o = generating(parts, fingers, identical);
      EXPECT_EQ(RoutingGenerator(o).total(), std::get<0>(formula_counts(o))) << label_of(o);
    }
    for (int fingers = 1; fingers <= 8; ++fingers) {
      const GeneratorOptions o = generating(parts, fingers, distinct);
      EXPECT_EQ(RoutingGenerator(o).total(), std::get<0>(formula_counts(o))) << label_of(o);
    }
  }
}

TEST(Generator, CountsAreThoseOfBruteForce) {
  for (const FingerIdentity identity : {identical, distinct}) {
    for (int fingers = 1; fingers <= 3; ++fingers) {
      std::vector<PartSet> sets = odd_parts();
      sets.insert(sets.end(), {paper_parts(), full_parts()});
      for (const PartSet& parts : sets) {
        const GeneratorOptions o = generating(parts, fingers, identity);
        EXPECT_EQ(generated_counts(o), brute_force_counts(o)) << label_of(o);
      }
    }
  }
}

}  // namespace
}  // namespace reeve::testing
