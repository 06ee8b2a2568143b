#include "search/enumerate/shape_cursor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "core/canonical.hpp"
#include "core/notation.hpp"
#include "search/enumerate/counting.hpp"

namespace reeve {
namespace {

std::vector<Walk> extended(const std::vector<Walk>& walks, const std::vector<Token>& choices) {
  std::vector<Walk> longer;
  for (const Walk& walk : walks) {
    for (const Token& choice : choices) {
      longer.push_back(walk);
      longer.back().push_back(choice);
    }
  }
  return longer;
}

std::vector<Token> tokens(const std::vector<TokenKind>& kinds) {
  std::vector<Token> choices(kinds.size());
  std::transform(kinds.begin(), kinds.end(), choices.begin(), plain);
  return choices;
}

// Every string of parts in the order of tokens, canonical or not.
std::vector<Walk> all_walks(const PartSet& parts, int fingers, bool closed) {
  std::vector<Walk> walks{{}};
  if (!closed) walks = extended(walks, tokens(parts.ends));
  for (int f = 1; f <= fingers; ++f) {
    if (f > 1) walks = extended(walks, tokens(parts.joins));
    std::vector<Token> choices;
    for (const TipKind tip : parts.tips) choices.push_back(finger(f, tip));
    walks = extended(walks, choices);
  }
  return extended(walks, tokens(closed ? parts.joins : parts.ends));
}

// The first of each tendon's walks, open ones before loops.
std::vector<std::string> expected_shapes(const PartSet& parts, int fingers) {
  std::vector<std::string> words;
  std::set<std::string> seen;
  for (const bool closed : {false, true}) {
    for (const Walk& walk : all_walks(parts, fingers, closed)) {
      const Routing routing{{Tendon{walk, closed}}};
      if (seen.insert(to_word(canonical(routing, FingerIdentity::identical))).second) {
        words.push_back(to_word(routing));
      }
    }
  }
  return words;
}

std::string word_of(Tendon shape) {
  std::uint8_t next = 1;
  for (Token& token : shape.walk) {
    if (token.kind == TokenKind::finger) token.finger = next++;
  }
  return to_word(Routing{{shape}});
}

std::vector<std::string> shapes(ShapeCursor& cursor, const PartSet& parts, int fingers) {
  std::vector<std::string> words;
  for (bool more = cursor.start(parts, fingers); more; more = cursor.next(parts)) {
    EXPECT_EQ(cursor.index(), words.size());
    EXPECT_EQ(cursor.fingers(), fingers);
    words.push_back(word_of(cursor.shape()));
  }
  return words;
}

std::vector<std::string> shapes(const PartSet& parts, int fingers) {
  ShapeCursor cursor;
  return shapes(cursor, parts, fingers);
}

TEST(ShapeCursor, PaperTendonsThroughOneAndTwoFingers) {
  EXPECT_EQ(shapes(paper_parts(), 1),
            (std::vector<std::string>{"M-1-M", "M-1-F", "F-1-F", "1-T-1", "1-P-1"}));
  EXPECT_EQ(
      shapes(paper_parts(), 2),
      (std::vector<std::string>{"M-1-T-2-M", "M-1-T-2-F", "M-1-P-2-M", "M-1-P-2-F", "F-1-T-2-F",
                                "F-1-P-2-F", "1-T-2-T-1", "1-T-2-P-1", "1-P-2-P-1"}));
}

TEST(ShapeCursor, GivesTheFirstWalkOfEachTendonInOrder) {
  for (int fingers = 1; fingers <= 6; ++fingers) {
    EXPECT_EQ(shapes(paper_parts(), fingers), expected_shapes(paper_parts(), fingers));
  }
  for (int fingers = 1; fingers <= 4; ++fingers) {
    EXPECT_EQ(shapes(full_parts(), fingers), expected_shapes(full_parts(), fingers));
  }
}

TEST(ShapeCursor, OddSetsOfParts) {
  const std::vector<PartSet> sets{
      {parse_tips("tube,bearing"), parse_joins("T,B,P"), {}},  // loops only
      {parse_tips("tube,bearing"), {}, parse_ends("M,F")},     // one finger only
      {parse_tips("bearing"), parse_joins("P"), parse_ends("F")},
      {parse_tips("tube,bearing"), parse_joins("B"), {}},
      {parse_tips("tube,bearing"), parse_joins("B"), parse_ends("M")},
      {parse_tips("tube"), {}, parse_ends("F")},
      {parse_tips("tube"), parse_joins("T"), {}},
  };
  for (const PartSet& parts : sets) {
    SCOPED_TRACE(tips_text(parts) + " " + joins_text(parts) + " " + ends_text(parts));
    for (int fingers = 1; fingers <= 5; ++fingers) {
      const std::vector<std::string> found = shapes(parts, fingers);
      EXPECT_EQ(found, expected_shapes(parts, fingers));
      EXPECT_EQ(found.size(), tendon_counts(parts, fingers, FingerIdentity::identical).back());
    }
  }
}

TEST(ShapeCursor, CountAgreesForMoreFingers) {
  for (int fingers = 5; fingers <= 6; ++fingers) {
    const TendonCounts counts = tendon_counts(full_parts(), fingers, FingerIdentity::identical);
    EXPECT_EQ(shapes(full_parts(), fingers).size(), counts.back());
  }
}

TEST(ShapeCursor, NoShapeAtAll) {
  ShapeCursor cursor;
  const PartSet without_joins{parse_tips("tube"), {}, parse_ends("M,F")};
  EXPECT_FALSE(cursor.start(without_joins, 2));
  EXPECT_TRUE(cursor.start(without_joins, 1));
  EXPECT_FALSE(cursor.start({parse_tips("tube"), {}, {}}, 1));
}

TEST(ShapeCursor, ACursorCanBeUsedAgain) {
  ShapeCursor cursor;
  EXPECT_EQ(shapes(cursor, full_parts(), 3), shapes(full_parts(), 3));
  EXPECT_EQ(shapes(cursor, paper_parts(), 5), shapes(paper_parts(), 5));
  ASSERT_TRUE(cursor.start(full_parts(), 2));
  ASSERT_TRUE(cursor.next(full_parts()));
  ShapeCursor copy = cursor;
  ASSERT_TRUE(copy.next(full_parts()));
  EXPECT_EQ(cursor.index(), 1U);
  EXPECT_EQ(copy.index(), 2U);
  EXPECT_EQ(shapes(cursor, full_parts(), 1), shapes(full_parts(), 1));
}

}  // namespace
}  // namespace reeve
