#include "core/notation.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

std::string message(const std::string& word) {
  return testing::input_error([&] { parse_routing(word); });
}

std::string at(const std::string& word, int column, const std::string& problem) {
  return "routing '" + word + "', column " + std::to_string(column) + ": " + problem;
}

const std::string expected_tokens =
    ": expected M, F, T, B, P, a finger such as 1, 2b or 3x, a block such as Y1 or Y1k, or a bar such "
    "as W1";
const std::string needs_ends =
    "a walk must begin and end with M, F, a fingertip (1x) or a block (Y1), or come back to the finger "
    "that it began with, and ";

TEST(Notation, ReadsAnOpenWalkTokenByToken) {
  const Routing routing = parse_routing("M-1-T-2b-B-3-P-4-F");
  ASSERT_EQ(routing.tendons.size(), 1U);
  EXPECT_FALSE(routing.tendons[0].closed);
  const Walk walk{motor_end(),
                  finger(1),
                  plain(TokenKind::tube_join),
                  finger(2, TipKind::bearing),
                  plain(TokenKind::bearing_join),
                  finger(3),
                  plain(TokenKind::movable_pulley),
                  finger(4),
                  fixed_end()};
  EXPECT_EQ(routing.tendons[0].walk, walk);
}

TEST(Notation, ReadsAWalkThatComesBackToItsFirstFingerAsALoop) {
  const Tendon loop = parse_routing("1b-T-2-P-1b").tendons.at(0);
  EXPECT_TRUE(loop.closed);
  const Walk walk{finger(1, TipKind::bearing), plain(TokenKind::tube_join), finger(2),
                  plain(TokenKind::movable_pulley)};
  EXPECT_EQ(loop.walk, walk);
}

TEST(Notation, ReadsTendonsBetweenPluses) {
  const Routing routing = parse_routing("M-2-F+1-P-1+M-F");
  ASSERT_EQ(routing.tendons.size(), 3U);
  EXPECT_FALSE(routing.tendons[0].closed);
  EXPECT_TRUE(routing.tendons[1].closed);
  EXPECT_EQ(routing.tendons[2].walk, (Walk{motor_end(), fixed_end()}));
}

TEST(Notation, PrintsWhatItRead) {
  for (const std::string word : {"M-F", "M-T-F", "M-P-F", "M-T-P-B-M", "F-1-F", "1-T-1", "1b-P-1b",
                                 "M-1-T-2-F", "1-P-2b-P-1+M-3-F", "F-P-P-1-T-B-2-F+3-B-3"}) {
    EXPECT_EQ(to_word(parse_routing(word)), word);
  }
}

TEST(Notation, ReadsAsManyFingersAsAGraspCanHold) {
  std::string word = "M-1";
  for (int f = 2; f <= max_fingers; ++f) word += "-T-" + std::to_string(f);
  word += "-F";
  EXPECT_EQ(to_word(parse_routing(word)), word);
  EXPECT_EQ(finger_count(parse_routing(word)), max_fingers);
}

TEST(NotationError, EmptyWord) {
  EXPECT_EQ(message(""), "routing '': the word is empty; expected e.g. M-1-T-2-F");
}

TEST(NotationError, UnknownToken) {
  EXPECT_EQ(message("M-1-X-2-F"), at("M-1-X-2-F", 5, "unknown token 'X'" + expected_tokens));
  EXPECT_EQ(message("m-1-F"), at("m-1-F", 1, "unknown token 'm'" + expected_tokens));
  EXPECT_EQ(message("M-1-TT-2-F"), at("M-1-TT-2-F", 5, "unknown token 'TT'" + expected_tokens));
  EXPECT_EQ(message("M - 1-F"), at("M - 1-F", 1, "unknown token 'M '" + expected_tokens));
  EXPECT_EQ(message("-1-F"), at("-1-F", 1, "an empty token" + expected_tokens));
}

TEST(NotationError, UnknownSuffixOfAFinger) {
  EXPECT_EQ(message("M-1c-F"), at("M-1c-F", 3,
                                  "'1c': expected behind the finger number no suffix (tube at the "
                                  "fingertip), b (bearing) or x (the tendon is tied there)"));
}

TEST(NotationError, FingerPassedTwice) {
  const std::string twice = "finger 1 is passed twice; a finger has two strands and one tendon";
  EXPECT_EQ(message("M-1-T-1-F"), at("M-1-T-1-F", 7, twice));
  EXPECT_EQ(message("M-1-F+M-1-F"), at("M-1-F+M-1-F", 9, twice));
  EXPECT_EQ(message("1-P-2-T-1-T-1"), at("1-P-2-T-1-T-1", 9, twice));
}

TEST(NotationError, FingerNumberOutOfRange) {
  const std::string range = "expected a finger number from 1 to 64";
  EXPECT_EQ(message("M-0-F"), at("M-0-F", 3, "'0': " + range));
  EXPECT_EQ(message("M-01-F"), at("M-01-F", 3, "'01': " + range));
  EXPECT_EQ(message("M-65-F"), at("M-65-F", 3, "'65': " + range));
  EXPECT_EQ(message("M-99999999999999999999b-F"),
            at("M-99999999999999999999b-F", 3, "'99999999999999999999b': " + range));
}

TEST(NotationError, FingerGap) {
  EXPECT_EQ(message("M-1-T-3-F"),
            "routing 'M-1-T-3-F': finger 2 is missing; fingers are numbered 1 to 3 without a gap");
  EXPECT_EQ(message("M-2-F"),
            "routing 'M-2-F': finger 1 is missing; fingers are numbered 1 to 2 without a gap");
}

TEST(NotationError, MissingEnd) {
  EXPECT_EQ(message("M-1"), at("M-1", 3, needs_ends + "'1' does neither"));
  EXPECT_EQ(message("1-T-2-F"), at("1-T-2-F", 1, needs_ends + "'1' does neither"));
  EXPECT_EQ(message("1-P-2"), at("1-P-2", 1, needs_ends + "'1' does neither"));
  EXPECT_EQ(message("M-1-F+2-T"), at("M-1-F+2-T", 7, needs_ends + "'2' does neither"));
  EXPECT_EQ(message("P"), at("P", 1, needs_ends + "'P' does neither"));
  EXPECT_EQ(message("1"), at("1", 1, needs_ends + "'1' does neither"));
  EXPECT_EQ(message("T-1-T"), at("T-1-T", 1, needs_ends + "'T' does neither"));
}

TEST(NotationError, OneEndAlone) {
  EXPECT_EQ(message("M"), at("M", 1, "the walk has one token: a second end is missing"));
  EXPECT_EQ(message("M-1-F+F"),
            at("M-1-F+F", 7, "the walk has one token: a second end is missing"));
}

TEST(NotationError, AdjacentFingers) {
  EXPECT_EQ(
      message("M-1-2-F"),
      at("M-1-2-F", 5, "between two fingers a join is needed: T, B, P or a block before '2'"));
  EXPECT_EQ(message("1-1"),
            at("1-1", 3, "between two fingers a join is needed: T, B, P or a block before '1'"));
}

TEST(NotationError, EndInsideAWalk) {
  const std::string inside = " ends a walk and cannot stand inside it; join tendons with +";
  EXPECT_EQ(message("M-1-M-2-F"), at("M-1-M-2-F", 5, "'M'" + inside));
  EXPECT_EQ(message("1-F-1"), at("1-F-1", 3, "'F'" + inside));
}

TEST(NotationError, LoopThatComesBackToAnotherTip) {
  EXPECT_EQ(message("1-T-2-P-1b"),
            at("1-T-2-P-1b", 9,
               "the loop begins with '1' and comes back to '1b': expected the same token"));
}

TEST(NotationError, EmptyTokens) {
  const std::string empty = "an empty token" + expected_tokens;
  EXPECT_EQ(message("M-1-F+"), at("M-1-F+", 7, empty));
  EXPECT_EQ(message("+M-1-F"), at("+M-1-F", 1, empty));
  EXPECT_EQ(message("M--1-F"), at("M--1-F", 3, empty));
  EXPECT_EQ(message("M-1-F-"), at("M-1-F-", 7, empty));
  EXPECT_EQ(message("-"), at("-", 1, empty));
}

TEST(NotationError, BytesThatCannotBePrintedAreShownAsQuestionMarks) {
  const std::string shown(4, '?');
  EXPECT_EQ(message(std::string("M-\x01\x1b\0\x7f-F", 8)),
            at("M-" + shown + "-F", 3, "unknown token '" + shown + "'" + expected_tokens));
  EXPECT_EQ(message("M\n-F"), at("M?-F", 1, "unknown token 'M?'" + expected_tokens));
}

TEST(NotationError, LettersOutsideAsciiAreShownAsTheyAre) {
  EXPECT_EQ(message("M-é-F"), at("M-é-F", 3, "unknown token 'é'" + expected_tokens));
}

TEST(NotationError, LongWordsAreShortened) {
  const std::string token(100, 'X');
  const std::string shown = "'" + std::string(60, 'X') + "…'";
  EXPECT_EQ(message(token),
            "routing " + shown + ", column 1: unknown token " + shown + expected_tokens);
}

TEST(NotationError, TenMegabytesAreRefusedAtOnce) {
  const std::string word(10'000'000, '-');
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(message(word), "routing '" + std::string(60, '-') +
                               "…': the word has 10000000 characters, at most 4096 are read");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

TEST(NotationError, TheLongestWordThatIsReadIsReadAtOnce) {
  std::string word = "M";
  while (word.size() + 2 <= 4096) word += "-T";
  const auto start = std::chrono::steady_clock::now();
  message(word);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

TEST(NotationFault, HasTheTokenInParts) {
  const auto parts = [](const std::string& word) {
    return testing::input_fault([&] { parse_routing(word); });
  };
  EXPECT_EQ(parts("M-1-Q"),
            "routing 'M-1-Q', column 5 | unknown token | Q | M, F, T, B, P or a finger number such "
            "as 1 or 2b");
  EXPECT_EQ(parts("M-65-F"), "routing 'M-65-F', column 3 |  | 65 | a finger number from 1 to 64");
  EXPECT_EQ(
      parts("M-1-1-F"),
      "routing 'M-1-1-F', column 5 | between two fingers a join is needed: T, B, P or a block before "
      "'1' | - | ");
}

}  // namespace
}  // namespace reeve
