#include "search/enumerate/generator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/counting.hpp"

namespace reeve {
namespace {

constexpr FingerIdentity identical = FingerIdentity::identical;
constexpr FingerIdentity distinct = FingerIdentity::distinct;

PartSet parts_of(const char* tips, const char* joins, const char* ends) {
  return {parse_tips(tips), parse_joins(joins), parse_ends(ends)};
}

// No joins, no ends, one kind only, no motor, nothing but motor.
std::vector<PartSet> odd_parts() {
  return {
      parts_of("tube", "T,P", ""),       parts_of("tube,bearing", "T,B,P", ""),
      parts_of("tube", "", "M,F"),       parts_of("tube,bearing", "", "M,F"),
      parts_of("tube", "P", ""),         parts_of("tube", "T", ""),
      parts_of("bearing", "", "M"),      parts_of("tube", "", "F"),
      parts_of("tube", "P", "F"),        parts_of("bearing", "T", "M"),
      parts_of("tube", "P", "M"),        parts_of("tube,bearing", "B", "F"),
      parts_of("bearing", "B,P", "M,F"),
  };
}

GeneratorOptions options(const PartSet& parts, int fingers, FingerIdentity identity,
                         bool one_tendon = false) {
  return {parts, fingers, identity, one_tendon};
}

std::string label(const GeneratorOptions& o) {
  return tips_text(o.parts) + " " + joins_text(o.parts) + " " + ends_text(o.parts) + ", " +
         std::to_string(o.fingers) + (o.identity == distinct ? " distinct" : "") + " fingers" +
         (o.one_tendon ? ", one tendon" : "");
}

void for_each(const GeneratorOptions& o, const std::function<void(const Routing&)>& visit) {
  RoutingGenerator generator(o);
  Routing routing;
  while (generator.next(routing)) visit(routing);
}

std::vector<std::string> words(const GeneratorOptions& o) {
  std::vector<std::string> result;
  for_each(o, [&](const Routing& routing) { result.push_back(to_word(routing)); });
  return result;
}

// ---- counts ----

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

testing::CountedParts counted(const PartSet& parts) {
  const auto on_carriage = [](const std::vector<TokenKind>& kinds) {
    return static_cast<int>(std::count_if(kinds.begin(), kinds.end(), is_on_carriage));
  };
  testing::CountedParts result;
  result.tube_like_tips = static_cast<int>(parts.tips.size());
  result.motor_joins = on_carriage(parts.joins);
  result.passive_joins = static_cast<int>(parts.joins.size()) - result.motor_joins;
  result.motor_ends = on_carriage(parts.ends);
  result.fixed_ends = static_cast<int>(parts.ends.size()) - result.motor_ends;
  return result;
}

Counts formula_counts(const GeneratorOptions& o) {
  const auto c = o.identity == identical ? testing::count_identical(counted(o.parts), o.fingers)
                                         : testing::count_distinct(counted(o.parts), o.fingers);
  return {c.all, c.actuated, c.one_tendon};
}

Counts brute_force_counts(const GeneratorOptions& o) {
  const auto c = testing::brute_force_counts(counted(o.parts), o.fingers, o.identity == identical);
  return {c.all, c.actuated, c.one_tendon};
}

TEST(Generator, TableOfPaperParts) {
  EXPECT_EQ(generated_counts(options(paper_parts(), 1, identical)), Counts(5, 3, 3));
  EXPECT_EQ(generated_counts(options(paper_parts(), 2, identical)), Counts(24, 13, 7));
  EXPECT_EQ(generated_counts(options(paper_parts(), 3, identical)), Counts(94, 43, 12));
  EXPECT_EQ(generated_counts(options(paper_parts(), 4, identical)), Counts(346, 145, 24));
}

TEST(Generator, TableOfFullParts) {
  EXPECT_EQ(generated_counts(options(full_parts(), 1, identical)), Counts(12, 6, 6));
  EXPECT_EQ(generated_counts(options(full_parts(), 2, identical)), Counts(126, 54, 33));
  EXPECT_EQ(generated_counts(options(full_parts(), 3, identical)), Counts(1152, 426, 172));
  EXPECT_EQ(generated_counts(options(full_parts(), 4, identical)), Counts(9942, 3402, 990));
}

void expect_formula(const PartSet& parts, int most, FingerIdentity identity) {
  for (int fingers = 1; fingers <= most; ++fingers) {
    const GeneratorOptions o = options(parts, fingers, identity);
    EXPECT_EQ(generated_counts(o), formula_counts(o)) << label(o);
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
      const GeneratorOptions o = options(parts, fingers, identical);
      EXPECT_EQ(RoutingGenerator(o).total(), std::get<0>(formula_counts(o))) << label(o);
    }
    for (int fingers = 1; fingers <= 8; ++fingers) {
      const GeneratorOptions o = options(parts, fingers, distinct);
      EXPECT_EQ(RoutingGenerator(o).total(), std::get<0>(formula_counts(o))) << label(o);
    }
  }
}

TEST(Generator, CountsAreThoseOfBruteForce) {
  for (const FingerIdentity identity : {identical, distinct}) {
    for (int fingers = 1; fingers <= 3; ++fingers) {
      for (const PartSet& parts : {paper_parts(), full_parts()}) {
        const GeneratorOptions o = options(parts, fingers, identity);
        EXPECT_EQ(generated_counts(o), brute_force_counts(o)) << label(o);
      }
      for (const PartSet& parts : odd_parts()) {
        const GeneratorOptions o = options(parts, fingers, identity);
        EXPECT_EQ(generated_counts(o), brute_force_counts(o)) << label(o);
      }
    }
  }
}

// ---- what is generated ----

int rank(const Token& token) {
  switch (token.kind) {
    case TokenKind::motor_end:
      return 0;
    case TokenKind::fixed_end:
      return 1;
    case TokenKind::finger:
      return token.tip == TipKind::tube ? 2 : 3;
    case TokenKind::tube_join:
      return 4;
    case TokenKind::bearing_join:
      return 5;
    case TokenKind::movable_pulley:
      return 6;
  }
  return 7;
}

// Compares as canonical.hpp says: the tendons' shapes, and then the numbers of the fingers.
struct OrderKey {
  std::vector<std::tuple<int, bool, std::vector<int>>> shapes;
  std::vector<int> numbers;

  friend auto operator<=>(const OrderKey&, const OrderKey&) = default;
};

OrderKey order_key(const Routing& routing) {
  OrderKey key;
  for (const Tendon& tendon : routing.tendons) {
    std::vector<int> ranks;
    for (const Token& token : tendon.walk) {
      ranks.push_back(rank(token));
      if (token.kind == TokenKind::finger) key.numbers.push_back(token.finger);
    }
    key.shapes.emplace_back(-finger_count(tendon), tendon.closed, ranks);
  }
  return key;
}

void expect_good_routings(const GeneratorOptions& o) {
  SCOPED_TRACE(label(o));
  std::set<std::string> seen;
  OrderKey before;
  for_each(o, [&](const Routing& routing) {
    const std::string word = to_word(routing);
    ASSERT_EQ(finger_count(routing), o.fingers) << word;
    ASSERT_EQ(to_word(canonical(routing, o.identity)), word);
    ASSERT_EQ(canonical(routing, o.identity), routing) << word;
    ASSERT_EQ(parse_routing(word), routing) << word;
    ASSERT_TRUE(seen.insert(word).second) << word;
    OrderKey key = order_key(routing);
    ASSERT_LT(before, key) << word;
    before = std::move(key);
  });
}

TEST(Generator, RoutingsAreCanonicalAndUniqueAndInOrderAndPrintBack) {
  for (const bool one_tendon : {false, true}) {
    for (int fingers = 1; fingers <= 6; ++fingers) {
      expect_good_routings(options(paper_parts(), fingers, identical, one_tendon));
    }
    for (int fingers = 1; fingers <= 4; ++fingers) {
      expect_good_routings(options(full_parts(), fingers, identical, one_tendon));
      expect_good_routings(options(paper_parts(), fingers, distinct, one_tendon));
    }
    for (int fingers = 1; fingers <= 3; ++fingers) {
      expect_good_routings(options(full_parts(), fingers, distinct, one_tendon));
    }
    for (const PartSet& parts : odd_parts()) {
      expect_good_routings(options(parts, 4, identical, one_tendon));
      expect_good_routings(options(parts, 3, distinct, one_tendon));
    }
  }
}

TEST(Generator, RoutingsOfOneFinger) {
  EXPECT_EQ(words(options(full_parts(), 1, identical)),
            (std::vector<std::string>{"M-1-M", "M-1-F", "M-1b-M", "M-1b-F", "F-1-F", "F-1b-F",
                                      "1-T-1", "1-B-1", "1-P-1", "1b-T-1b", "1b-B-1b", "1b-P-1b"}));
}

TEST(Generator, RoutingsOfTwoFingersWithoutPulleys) {
  EXPECT_EQ(words(options(parts_of("tube", "T", "M,F"), 2, identical)),
            (std::vector<std::string>{"M-1-T-2-M", "M-1-T-2-F", "F-1-T-2-F", "1-T-2-T-1",
                                      "M-1-M+M-2-M", "M-1-M+M-2-F", "M-1-M+F-2-F", "M-1-M+2-T-2",
                                      "M-1-F+M-2-F", "M-1-F+F-2-F", "M-1-F+2-T-2", "F-1-F+F-2-F",
                                      "F-1-F+2-T-2", "1-T-1+2-T-2"}));
}

TEST(Generator, RoutingsOfTwoDistinctFingers) {
  EXPECT_EQ(
      words(options(parts_of("tube", "P", "M,F"), 2, distinct)),
      (std::vector<std::string>{
          "M-1-P-2-M",   "M-1-P-2-F",   "M-2-P-1-F",   "F-1-P-2-F",   "1-P-2-P-1",   "M-1-M+M-2-M",
          "M-1-M+M-2-F", "M-2-M+M-1-F", "M-1-M+F-2-F", "M-2-M+F-1-F", "M-1-M+2-P-2", "M-2-M+1-P-1",
          "M-1-F+M-2-F", "M-1-F+F-2-F", "M-2-F+F-1-F", "M-1-F+2-P-2", "M-2-F+1-P-1", "F-1-F+F-2-F",
          "F-1-F+2-P-2", "F-2-F+1-P-1", "1-P-1+2-P-2"}));
}

std::vector<std::string> actuated_words(const GeneratorOptions& o) {
  std::vector<std::string> result;
  for_each(o, [&](const Routing& routing) {
    if (is_actuated(routing)) result.push_back(to_word(routing));
  });
  return result;
}

TEST(Generator, TwoFingersWithPaperPartsAreTheSevenOfThePaper) {
  EXPECT_EQ(actuated_words(options(paper_parts(), 2, identical, true)),
            (std::vector<std::string>{"M-1-T-2-M",     // TR2
                                      "M-1-T-2-F",     // TR1
                                      "M-1-P-2-M",     // TR5
                                      "M-1-P-2-F",     // TR4
                                      "F-1-P-2-F",     // TR3
                                      "1-T-2-P-1",     // TR6
                                      "1-P-2-P-1"}));  // TR7
}

std::vector<int> fingers_along(const Walk& walk) {
  std::vector<int> numbers;
  for (const Token& token : walk) {
    if (token.kind == TokenKind::finger) numbers.push_back(token.finger);
  }
  return numbers;
}

std::vector<Walk> ways_to_walk(const Tendon& tendon) {
  std::vector<Walk> ways;
  for (const bool backward : {false, true}) {
    Walk walk = tendon.walk;
    if (backward) std::reverse(walk.begin(), walk.end());
    for (std::size_t i = 0; i < (tendon.closed ? walk.size() : 1); ++i) {
      ways.push_back(walk);
      std::rotate(walk.begin(), walk.begin() + 1, walk.end());
    }
  }
  return ways;
}

// A walk that passes 1, 2, …, n and whose two outer strands are closed in one of four ways: M and
// M, M and F with M at finger 1, F and F, or one pulley P. The joins between are free.
bool is_in_the_papers_order(const Tendon& tendon) {
  const std::vector<Walk> ways = ways_to_walk(tendon);
  return std::any_of(ways.begin(), ways.end(), [&](const Walk& walk) {
    if (tendon.closed && !is_join(walk.back().kind)) return false;
    const std::vector<int> numbers = fingers_along(walk);
    if (!std::is_sorted(numbers.begin(), numbers.end())) return false;
    return tendon.closed ? walk.back().kind == TokenKind::movable_pulley
                         : walk.front().kind <= walk.back().kind;
  });
}

// 4 closings and 2^(n-1) choices of joins, less F-1-T-2-…-F, which no motor pulls.
TEST(Generator, FingersInFixedOrderMakeTheNumberOfThePaper) {
  for (int fingers = 1; fingers <= 6; ++fingers) {
    std::uint64_t count = 0;
    for_each(options(paper_parts(), fingers, distinct, true), [&](const Routing& routing) {
      if (is_actuated(routing) && is_in_the_papers_order(routing.tendons.front())) ++count;
    });
    EXPECT_EQ(count, (std::uint64_t{1} << (fingers + 1)) - 1) << fingers << " fingers";
  }
}

TEST(Generator, OneTendonGivesTheRoutingsOfOneTendon) {
  const auto expect_filtered = [](const PartSet& parts, int fingers, FingerIdentity identity) {
    std::vector<std::string> expected;
    for_each(options(parts, fingers, identity), [&](const Routing& routing) {
      if (routing.tendons.size() == 1) expected.push_back(to_word(routing));
    });
    const GeneratorOptions o = options(parts, fingers, identity, true);
    EXPECT_EQ(words(o), expected) << label(o);
    EXPECT_EQ(RoutingGenerator(o).total(), expected.size()) << label(o);
  };
  for (int fingers = 1; fingers <= 4; ++fingers) {
    expect_filtered(paper_parts(), fingers, identical);
    expect_filtered(paper_parts(), fingers, distinct);
    expect_filtered(full_parts(), fingers, identical);
    for (const PartSet& parts : odd_parts()) {
      expect_filtered(parts, fingers, identical);
      expect_filtered(parts, fingers, distinct);
    }
  }
  expect_filtered(full_parts(), 3, distinct);
}

TEST(Generator, OneTendonWithoutJoinsPassesOneFingerOnly) {
  const PartSet parts = parts_of("tube", "", "M,F");
  RoutingGenerator generator(options(parts, 2, identical, true));
  Routing routing;
  EXPECT_EQ(generator.total(), 0U);
  EXPECT_FALSE(generator.next(routing));
  generator.seek(0);
  EXPECT_FALSE(generator.next(routing));
  EXPECT_EQ(words(options(parts, 1, identical, true)).size(), 3U);
}

TEST(Generator, AfterTheEndNothingFollows) {
  for (const FingerIdentity identity : {identical, distinct}) {
    RoutingGenerator generator(options(paper_parts(), 2, identity));
    Routing routing;
    while (generator.next(routing)) continue;
    const Routing last = routing;
    EXPECT_FALSE(generator.next(routing));
    EXPECT_FALSE(generator.next(routing));
    EXPECT_EQ(routing, last);
  }
}

// ---- seek ----

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
  SCOPED_TRACE(label(o));
  const std::vector<std::string> whole = words(o);
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
      expect_seek_everywhere(options(paper_parts(), fingers, identical, one_tendon));
    }
    for (int fingers = 1; fingers <= 3; ++fingers) {
      expect_seek_everywhere(options(full_parts(), fingers, identical, one_tendon));
      expect_seek_everywhere(options(paper_parts(), fingers, distinct, one_tendon));
    }
    expect_seek_everywhere(options(paper_parts(), 4, distinct, one_tendon));
    expect_seek_everywhere(options(full_parts(), 2, distinct, one_tendon));
    for (const PartSet& parts : odd_parts()) {
      expect_seek_everywhere(options(parts, 4, identical, one_tendon));
      expect_seek_everywhere(options(parts, 3, distinct, one_tendon));
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
  SCOPED_TRACE(label(o));
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
       {options(full_parts(), 6, identical), options(paper_parts(), 8, identical),
        options(full_parts(), 6, identical, true), options(paper_parts(), 5, distinct),
        options(full_parts(), 4, distinct), options(paper_parts(), 6, distinct, true)}) {
    expect_seek_at(o, random_indices(RoutingGenerator(o).total(), 200));
  }
}

TEST(Generator, SeekBehindTheLastGivesNothing) {
  for (const FingerIdentity identity : {identical, distinct}) {
    for (const bool one_tendon : {false, true}) {
      RoutingGenerator generator(options(paper_parts(), 3, identity, one_tendon));
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
  const GeneratorOptions o = options(paper_parts(), 3, distinct);
  const std::vector<std::string> whole = words(o);
  RoutingGenerator generator(o);
  generator.seek(200);
  generator.seek(300);
  generator.seek(7);
  Routing routing;
  ASSERT_TRUE(generator.next(routing));
  EXPECT_EQ(to_word(routing), whole[7]);
}

// ---- shards ----

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
  EXPECT_EQ(together, words(o)) << label(o) << ", " << n << " shards";
}

TEST(Shards, ShardsTogetherAreTheWhole) {
  for (const std::uint64_t n : {1U, 2U, 3U, 7U, 100U, 1500U}) {
    expect_shards_make_the_whole(options(full_parts(), 3, identical), n);
    expect_shards_make_the_whole(options(full_parts(), 3, identical, true), n);
    expect_shards_make_the_whole(options(full_parts(), 2, distinct), n);
    expect_shards_make_the_whole(options(paper_parts(), 4, distinct), n);
  }
  expect_shards_make_the_whole(options(full_parts(), 5, identical), 11);
}

// ---- large spaces ----

// A piece of a large space: every routing is as it should be, and the piece ends where seek says.
void expect_good_piece(const GeneratorOptions& o, std::uint64_t begin, std::uint64_t size) {
  SCOPED_TRACE(label(o));
  RoutingGenerator generator(o);
  generator.seek(begin);
  Routing routing;
  OrderKey before;
  for (std::uint64_t i = 0; i < size; ++i) {
    ASSERT_TRUE(generator.next(routing));
    ASSERT_EQ(canonical(routing, o.identity), routing) << to_word(routing);
    OrderKey key = order_key(routing);
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
    const GeneratorOptions o = options(full_parts(), 8, identical, one_tendon);
    const std::uint64_t total = RoutingGenerator(o).total();
    expect_good_piece(o, 0, 5000);
    expect_good_piece(o, total / 2, 5000);
    expect_good_piece(o, total - 5001, 5000);
  }
  const GeneratorOptions o = options(paper_parts(), 8, distinct);
  expect_good_piece(o, RoutingGenerator(o).total() / 2, 5000);
}

TEST(Generator, ManyFingersBeginAtOnce) {
  expect_good_piece(options(full_parts(), 12, identical), 0, 1000);
  expect_good_piece(options(full_parts(), 10, distinct), 0, 1000);
}

// Loops round one tube: one way for each partition of 64. (OEIS A000041)
TEST(Generator, SixtyFourFingers) {
  RoutingGenerator generator(options(parts_of("tube", "T", ""), 64, identical));
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

std::string error_of(const GeneratorOptions& o) {
  try {
    RoutingGenerator generator(o);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Generator, ImpossibleOptionsAreRefused) {
  const PartSet paper = paper_parts();
  EXPECT_EQ(error_of(options(paper, 0, identical)), "fingers 0: expected a number from 1 to 64");
  EXPECT_EQ(error_of(options(paper, -1, identical)), "fingers -1: expected a number from 1 to 64");
  EXPECT_EQ(error_of(options(paper, 65, distinct)), "fingers 65: expected a number from 1 to 64");
  EXPECT_EQ(error_of(options({{}, paper.joins, paper.ends}, 2, identical)),
            "tips '': expected at least one of tube, bearing");
  EXPECT_EQ(error_of(options({paper.tips, {}, {}}, 2, identical)),
            "joins '', ends '': expected at least one join or one end");
}

TEST(Generator, MoreThanTwoToThe63RoutingsAreRefused) {
  const std::string expected =
      "these parts and fingers make more than 2^63 routings: fewer fingers or parts are needed";
  EXPECT_EQ(error_of(options(full_parts(), 64, identical)), expected);
  EXPECT_EQ(error_of(options(full_parts(), 64, identical, true)), expected);
  EXPECT_EQ(error_of(options(paper_parts(), 20, distinct)), expected);
}

}  // namespace
}  // namespace reeve
