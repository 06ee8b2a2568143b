#include "search/enumerate/generator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/search/generated.hpp"
#include "tests/support/input_error.hpp"

namespace reeve::testing {
namespace {

void expect_good_routings(const GeneratorOptions& o) {
  SCOPED_TRACE(label_of(o));
  std::set<std::string> seen;
  CanonicalKey before;
  for_each_generated(o, [&](const Routing& routing) {
    const std::string word = to_word(routing);
    ASSERT_EQ(finger_count(routing), o.fingers) << word;
    ASSERT_EQ(to_word(canonical(routing, o.identity)), word);
    ASSERT_EQ(canonical(routing, o.identity), routing) << word;
    ASSERT_EQ(parse_routing(word), routing) << word;
    ASSERT_TRUE(seen.insert(word).second) << word;
    CanonicalKey key = canonical_key(routing);
    ASSERT_LT(before, key) << word;
    before = std::move(key);
  });
}

TEST(Generator, RoutingsAreCanonicalAndUniqueAndInOrderAndPrintBack) {
  for (const bool one_tendon : {false, true}) {
    for (int fingers = 1; fingers <= 6; ++fingers) {
      expect_good_routings(generating(paper_parts(), fingers, identical, one_tendon));
    }
    for (int fingers = 1; fingers <= 4; ++fingers) {
      expect_good_routings(generating(full_parts(), fingers, identical, one_tendon));
      expect_good_routings(generating(paper_parts(), fingers, distinct, one_tendon));
    }
    for (int fingers = 1; fingers <= 3; ++fingers) {
      expect_good_routings(generating(full_parts(), fingers, distinct, one_tendon));
    }
    for (const PartSet& parts : odd_parts()) {
      expect_good_routings(generating(parts, 4, identical, one_tendon));
      expect_good_routings(generating(parts, 3, distinct, one_tendon));
    }
  }
}

TEST(Generator, RoutingsWithAnchoredTipsAreCanonicalAndInOrderToo) {
  for (const bool one_tendon : {false, true}) {
    for (int fingers = 1; fingers <= 4; ++fingers) {
      expect_good_routings(generating(anchored(paper_parts()), fingers, identical, one_tendon));
    }
    expect_good_routings(generating(anchored(full_parts()), 3, identical, one_tendon));
    expect_good_routings(generating(anchored(paper_parts()), 3, distinct, one_tendon));
    for (const PartSet& parts : odd_parts()) {
      expect_good_routings(generating(anchored(parts), 3, identical, one_tendon));
      expect_good_routings(generating(anchored(parts), 2, distinct, one_tendon));
    }
  }
}

TEST(Generator, RoutingsWithJoinsBesideEndsAreCanonicalAndInOrderToo) {
  for (const bool one_tendon : {false, true}) {
    for (const char* joins : {"P", "T,B,P"}) {
      for (const PartSet& parts : {paper_parts(), anchored(paper_parts())}) {
        const PartSet beside = with_beside(parts, joins);
        for (int fingers = 1; fingers <= 3; ++fingers) {
          expect_good_routings(generating(beside, fingers, identical, one_tendon));
        }
        expect_good_routings(generating(beside, 2, distinct, one_tendon));
      }
    }
  }
}

TEST(Generator, RoutingsWithAnchoredTipsOfTwoFingers) {
  EXPECT_EQ(generated_words(generating(anchored(parts_of("tube", "T", "M")), 2, identical)),
            (std::vector<std::string>{"M-1-T-2x", "M-1-T-2-M", "1x-T-2x", "1-T-2-T-1", "M-1x+M-2x",
                                      "M-1x+M-2-M", "M-1x+2-T-2", "M-1-M+M-2-M", "M-1-M+2-T-2",
                                      "1-T-1+2-T-2"}));
}

TEST(Generator, RoutingsOfOneFinger) {
  EXPECT_EQ(generated_words(generating(full_parts(), 1, identical)),
            (std::vector<std::string>{"M-1-M", "M-1-F", "M-1b-M", "M-1b-F", "F-1-F", "F-1b-F",
                                      "1-T-1", "1-B-1", "1-P-1", "1b-T-1b", "1b-B-1b", "1b-P-1b"}));
}

TEST(Generator, RoutingsOfTwoFingersWithoutPulleys) {
  EXPECT_EQ(generated_words(generating(parts_of("tube", "T", "M,F"), 2, identical)),
            (std::vector<std::string>{"M-1-T-2-M", "M-1-T-2-F", "F-1-T-2-F", "1-T-2-T-1",
                                      "M-1-M+M-2-M", "M-1-M+M-2-F", "M-1-M+F-2-F", "M-1-M+2-T-2",
                                      "M-1-F+M-2-F", "M-1-F+F-2-F", "M-1-F+2-T-2", "F-1-F+F-2-F",
                                      "F-1-F+2-T-2", "1-T-1+2-T-2"}));
}

TEST(Generator, RoutingsOfTwoDistinctFingers) {
  EXPECT_EQ(
      generated_words(generating(parts_of("tube", "P", "M,F"), 2, distinct)),
      (std::vector<std::string>{
          "M-1-P-2-M",   "M-1-P-2-F",   "M-2-P-1-F",   "F-1-P-2-F",   "1-P-2-P-1",   "M-1-M+M-2-M",
          "M-1-M+M-2-F", "M-2-M+M-1-F", "M-1-M+F-2-F", "M-2-M+F-1-F", "M-1-M+2-P-2", "M-2-M+1-P-1",
          "M-1-F+M-2-F", "M-1-F+F-2-F", "M-2-F+F-1-F", "M-1-F+2-P-2", "M-2-F+1-P-1", "F-1-F+F-2-F",
          "F-1-F+2-P-2", "F-2-F+1-P-1", "1-P-1+2-P-2"}));
}

std::vector<std::string> actuated_words(const GeneratorOptions& o) {
  std::vector<std::string> result;
  for_each_generated(o, [&](const Routing& routing) {
    if (is_actuated(routing)) result.push_back(to_word(routing));
  });
  return result;
}

TEST(Generator, TwoFingersWithPaperPartsAreTheSevenOfThePaper) {
  EXPECT_EQ(actuated_words(generating(paper_parts(), 2, identical, true)),
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
    for_each_generated(
        generating(paper_parts(), fingers, distinct, true), [&](const Routing& routing) {
          if (is_actuated(routing) && is_in_the_papers_order(routing.tendons.front())) ++count;
        });
    EXPECT_EQ(count, (std::uint64_t{1} << (fingers + 1)) - 1) << fingers << " fingers";
  }
}

TEST(Generator, OneTendonGivesTheRoutingsOfOneTendon) {
  const auto expect_filtered = [](const PartSet& parts, int fingers, FingerIdentity identity) {
    std::vector<std::string> expected;
    for_each_generated(generating(parts, fingers, identity), [&](const Routing& routing) {
      if (routing.tendons.size() == 1) expected.push_back(to_word(routing));
    });
    const GeneratorOptions o = generating(parts, fingers, identity, true);
    EXPECT_EQ(generated_words(o), expected) << label_of(o);
    EXPECT_EQ(RoutingGenerator(o).total(), expected.size()) << label_of(o);
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
  RoutingGenerator generator(generating(parts, 2, identical, true));
  Routing routing;
  EXPECT_EQ(generator.total(), 0U);
  EXPECT_FALSE(generator.next(routing));
  generator.seek(0);
  EXPECT_FALSE(generator.next(routing));
  EXPECT_EQ(generated_words(generating(parts, 1, identical, true)).size(), 3U);
}

TEST(Generator, AfterTheEndNothingFollows) {
  for (const FingerIdentity identity : {identical, distinct}) {
    RoutingGenerator generator(generating(paper_parts(), 2, identity));
    Routing routing;
    while (generator.next(routing)) continue;
    const Routing last = routing;
    EXPECT_FALSE(generator.next(routing));
    EXPECT_FALSE(generator.next(routing));
    EXPECT_EQ(routing, last);
  }
}

std::string error_of(const GeneratorOptions& o) {
  return input_error([&] { RoutingGenerator generator(o); });
}

TEST(Generator, ImpossibleOptionsAreRefused) {
  const PartSet paper = paper_parts();
  EXPECT_EQ(error_of(generating(paper, 0, identical)), "fingers 0: expected a number from 1 to 64");
  EXPECT_EQ(error_of(generating(paper, -1, identical)),
            "fingers -1: expected a number from 1 to 64");
  EXPECT_EQ(error_of(generating(paper, 65, distinct)),
            "fingers 65: expected a number from 1 to 64");
  EXPECT_EQ(error_of(generating({{}, paper.joins, paper.ends}, 2, identical)),
            "tips '': expected at least one of tube, bearing");
  EXPECT_EQ(error_of(generating({paper.tips, {}, {}}, 2, identical)),
            "joins '' without ends: expected at least one join or one end");
}

TEST(Generator, MoreThanTwoToThe63RoutingsAreRefused) {
  const std::string expected =
      "these parts and fingers make more than 2^63 routings: fewer fingers or parts are needed";
  EXPECT_EQ(error_of(generating(full_parts(), 64, identical)), expected);
  EXPECT_EQ(error_of(generating(full_parts(), 64, identical, true)), expected);
  EXPECT_EQ(error_of(generating(paper_parts(), 20, distinct)), expected);
}

}  // namespace
}  // namespace reeve::testing
