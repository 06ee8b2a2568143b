#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "search/enumerate/generator.hpp"
#include "tests/search/generated.hpp"

namespace reeve::testing {
namespace {

// From `index` on, the next few are those of the whole.
void expect_from(RoutingGenerator& generator, std::size_t index,
                 const std::vector<std::string>& whole) {
  generator.seek(index);
  Routing routing;
  for (std::size_t i = index; i < index + 3 && i < whole.size(); ++i) {
    ASSERT_TRUE(generator.next(routing)) << index;
    ASSERT_EQ(to_word(routing), whole[i]) << "from " << index;
  }
  ASSERT_EQ(generator.next(routing), index + 3 < whole.size()) << index;
}

// Backwards, so that seek comes from a generator that is further on.
void expect_seek_everywhere(const GeneratorOptions& o) {
  SCOPED_TRACE(label_of(o));
  const std::vector<std::string> whole = generated_words(o);
  RoutingGenerator used(o);
  for (std::size_t i = whole.size() + 2; i-- > 0;) expect_from(used, i, whole);
  for (std::size_t i = 0; i < whole.size(); i += 1 + whole.size() / 50) {
    RoutingGenerator fresh(o);
    expect_from(fresh, i, whole);
  }
}

TEST(Generator, SeekGoesToAnyIndex) {
  for (const bool one_tendon : {false, true}) {
    for (int fingers = 1; fingers <= 5; ++fingers) {
      expect_seek_everywhere(generating(paper_parts(), fingers, identical, one_tendon));
    }
    for (int fingers = 1; fingers <= 3; ++fingers) {
      expect_seek_everywhere(generating(full_parts(), fingers, identical, one_tendon));
      expect_seek_everywhere(generating(paper_parts(), fingers, distinct, one_tendon));
    }
    expect_seek_everywhere(generating(paper_parts(), 4, distinct, one_tendon));
    expect_seek_everywhere(generating(full_parts(), 2, distinct, one_tendon));
    for (const PartSet& parts : odd_parts()) {
      expect_seek_everywhere(generating(parts, 4, identical, one_tendon));
      expect_seek_everywhere(generating(parts, 3, distinct, one_tendon));
    }
  }
}

TEST(Generator, SeekGoesToAnyIndexOfAnchoredTipsAndBlocks) {
  for (const bool one_tendon : {false, true}) {
    expect_seek_everywhere(generating(anchored(paper_parts()), 4, identical, one_tendon));
    expect_seek_everywhere(generating(anchored(paper_parts()), 3, distinct, one_tendon));
    for (int fingers = 1; fingers <= 3; ++fingers) {
      const PartSet parts = with_blocks(anchored(paper_parts()), 2);
      expect_seek_everywhere(generating(parts, fingers, identical, one_tendon));
      if (fingers < 3) expect_seek_everywhere(generating(parts, fingers, distinct, one_tendon));
    }
    const PartSet beside = with_beside(with_blocks(anchored(paper_parts()), 1), "P");
    expect_seek_everywhere(generating(beside, 2, identical, one_tendon));
    for (const PartSet& parts : odd_parts()) {
      expect_seek_everywhere(generating(with_blocks(parts, 2), 3, identical, one_tendon));
      expect_seek_everywhere(generating(anchored(parts), 3, distinct, one_tendon));
    }
  }
}

std::vector<std::uint64_t> random_indices(std::uint64_t total, int many) {
  std::mt19937_64 engine(20240901);
  std::set<std::uint64_t> indices{0, 1, total / 2, total - 2, total - 1};
  for (int i = 0; i < many; ++i) indices.insert(engine() % total);
  return {indices.begin(), indices.end()};
}

void expect_seek_at(const GeneratorOptions& o, const std::vector<std::uint64_t>& indices) {
  SCOPED_TRACE(label_of(o));
  RoutingGenerator walking(o);
  RoutingGenerator seeking(o);
  Routing expected;
  Routing found;
  std::uint64_t given = 0;
  for (const std::uint64_t index : indices) {
    for (; given <= index; ++given) ASSERT_TRUE(walking.next(expected));
    seeking.seek(index);
    ASSERT_TRUE(seeking.next(found)) << index;
    ASSERT_EQ(found, expected) << index;
  }
}

TEST(Generator, SeekGoesToRandomIndicesOfLargerSpaces) {
  for (const auto& o :
       {generating(full_parts(), 6, identical), generating(paper_parts(), 8, identical),
        generating(full_parts(), 6, identical, true), generating(paper_parts(), 5, distinct),
        generating(full_parts(), 4, distinct), generating(paper_parts(), 6, distinct, true),
        generating(anchored(full_parts()), 4, identical),
        generating(with_blocks(all_parts(), 2), 4, identical)}) {
    expect_seek_at(o, random_indices(RoutingGenerator(o).total(), 200));
  }
}

TEST(Generator, SeekBehindTheLastGivesNothing) {
  for (const FingerIdentity identity : {identical, distinct}) {
    for (const bool one_tendon : {false, true}) {
      RoutingGenerator generator(generating(paper_parts(), 3, identity, one_tendon));
      Routing routing;
      for (const std::uint64_t beyond : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1000},
                                         ~std::uint64_t{0} - generator.total()}) {
        generator.seek(generator.total() + beyond);
        EXPECT_FALSE(generator.next(routing));
        EXPECT_FALSE(generator.next(routing));
      }
      generator.seek(generator.total() - 1);
      EXPECT_TRUE(generator.next(routing));
      EXPECT_FALSE(generator.next(routing));
      generator.seek(0);
      EXPECT_TRUE(generator.next(routing));
      EXPECT_EQ(to_word(routing), "M-1-T-2-T-3-M");
    }
  }
}

TEST(Generator, TheLastSeekCounts) {
  const GeneratorOptions o = generating(paper_parts(), 3, distinct);
  const std::vector<std::string> whole = generated_words(o);
  RoutingGenerator generator(o);
  generator.seek(200);
  generator.seek(300);
  generator.seek(7);
  Routing routing;
  ASSERT_TRUE(generator.next(routing));
  EXPECT_EQ(to_word(routing), whole[7]);
}

// A piece of a large space: every routing is as it should be, and the piece ends where seek says.
void expect_good_piece(const GeneratorOptions& o, std::uint64_t begin, std::uint64_t size) {
  SCOPED_TRACE(label_of(o));
  RoutingGenerator generator(o);
  generator.seek(begin);
  Routing routing;
  CanonicalKey before;
  for (std::uint64_t i = 0; i < size; ++i) {
    ASSERT_TRUE(generator.next(routing));
    ASSERT_EQ(canonical(routing, o.identity), routing) << to_word(routing);
    CanonicalKey key = canonical_key(routing);
    ASSERT_LT(before, key) << to_word(routing);
    before = std::move(key);
  }
  ASSERT_TRUE(generator.next(routing));
  RoutingGenerator other(o);
  other.seek(begin + size);
  Routing found;
  ASSERT_TRUE(other.next(found));
  EXPECT_EQ(found, routing);
}

TEST(Generator, StartsInTheMiddleOfEightFingers) {
  for (const bool one_tendon : {false, true}) {
    const GeneratorOptions o = generating(full_parts(), 8, identical, one_tendon);
    const std::uint64_t total = RoutingGenerator(o).total();
    expect_good_piece(o, 0, 5000);
    expect_good_piece(o, total / 2, 5000);
    expect_good_piece(o, total - 5001, 5000);
  }
  const GeneratorOptions o = generating(paper_parts(), 8, distinct);
  expect_good_piece(o, RoutingGenerator(o).total() / 2, 5000);
}

TEST(Generator, ManyFingersBeginAtOnce) {
  expect_good_piece(generating(full_parts(), 12, identical), 0, 1000);
  expect_good_piece(generating(full_parts(), 10, distinct), 0, 1000);
}

// Loops round one tube: one way for each partition of 64. (OEIS A000041)
TEST(Generator, SixtyFourFingers) {
  RoutingGenerator generator(generating(parts_of("tube", "T", ""), 64, identical));
  EXPECT_EQ(generator.total(), 1741630U);
  Routing routing;
  ASSERT_TRUE(generator.next(routing));
  EXPECT_EQ(routing.tendons.size(), 1U);
  ASSERT_TRUE(generator.next(routing));
  ASSERT_EQ(routing.tendons.size(), 2U);
  EXPECT_EQ(finger_count(routing.tendons[0]), 63);
  EXPECT_EQ(to_word(Routing{{routing.tendons[1]}}), "64-T-64");

  generator.seek(generator.total() - 1);
  ASSERT_TRUE(generator.next(routing));
  EXPECT_EQ(routing.tendons.size(), 64U);
  EXPECT_EQ(finger_count(routing), 64);
  EXPECT_FALSE(generator.next(routing));
}

}  // namespace
}  // namespace reeve::testing
