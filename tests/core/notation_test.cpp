#include "core/notation.hpp"

#include <fmt/format.h>
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

void expect_fault(const std::string& word, int column, const std::string& problem) {
  EXPECT_EQ(message(word), at(word, column, problem));
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

TEST(Notation, ReadsAnchoredTipsBlocksAndBars) {
  const Routing routing = parse_routing("M-Y1+Y1k-1x+2x-Y1-W1/3:1.5-3b-Y2+M-W1+4x-Y2-F");
  EXPECT_EQ(routing.tendons[0].walk, (Walk{motor_end(), block(TokenKind::block_tail, 1)}));
  EXPECT_EQ(routing.tendons[1].walk, (Walk{block(TokenKind::becket, 1), anchored_tip(1)}));
  const Walk walk{anchored_tip(2), block(TokenKind::block_pass, 1), bar(1, {2, 1}),
                  finger(3, TipKind::bearing), block(TokenKind::block_tail, 2)};
  EXPECT_EQ(routing.tendons[2].walk, walk);
  EXPECT_EQ(routing.tendons[3].walk, (Walk{motor_end(), block(TokenKind::bar_pivot, 1)}));
}

TEST(Notation, PrintsBlocksAndBarsAsItReadThem) {
  for (const std::string word :
       {"1x-P-2x", "M-Y1+1x-Y1-2x", "M-B-Y1-B-Y1k+Y1-1x", "M-W1+1x-W1/2:1-2x", "M-1-Y1+2-Y1-3-T-2",
        "1x-W1-2x+3x-W2-4x+W1-Y1-W2+Y1-M", "M-Y2-Y3k+Y2-Y1-Y3k+Y3-B-Y1k+Y1-1x",
        "M-W1+1x-W1/5:8-2b-F", "M-Y32+1x-Y32-2x", "M-Y3+W2-Y3-1x+2x-W2-3x"}) {
    EXPECT_EQ(to_word(parse_routing(word)), word);
  }
}

TEST(Notation, ReadsAndPrintsTheCarriagesOfSeveralMotors) {
  const Routing routing = parse_routing("M-1-P2-2-M3");
  EXPECT_EQ(routing.tendons[0].walk[0], motor_end());
  EXPECT_EQ(routing.tendons[0].walk[2], on_carriage(TokenKind::movable_pulley, 2));
  EXPECT_EQ(routing.tendons[0].walk[4], on_carriage(TokenKind::motor_end, 3));
  EXPECT_EQ(carriage_count(routing), 3);
  EXPECT_EQ(carriage_count(parse_routing("F-1-F")), 0);
  for (const char* word : {"M-1-P2-2-M3", "1-P-2-P2-1", "M6-1-M5+M4-M3+M2-M", "M-1b-M2"}) {
    EXPECT_EQ(to_word(parse_routing(word)), word);
  }
}

TEST(NotationError, NumbersOfMotors) {
  const auto one_of = [](const std::string& letter) {
    return ": expected " + letter + " alone for the first motor, or the number of another motor " +
           "behind it, from 2 to 6";
  };
  expect_fault("M-1-M0", 5, "'M0'" + one_of("M"));
  expect_fault("M-1-M1", 5, "'M1'" + one_of("M"));
  expect_fault("M-1-M7", 5, "'M7'" + one_of("M"));
  expect_fault("M-1-P2x-2-F", 5, "'P2x'" + one_of("P"));
  expect_fault("M-1-T2-2-F", 5, "unknown token 'T2'" + expected_tokens);
}

TEST(NotationError, MotorGap) {
  EXPECT_EQ(message("M-1-M3"),
            "routing 'M-1-M3': motor 2 is missing (M2 or P2); motors are numbered 1 to 3 without a "
            "gap");
  EXPECT_EQ(
      message("F-1-P2-2-F"),
      "routing 'F-1-P2-2-F': motor 1 is missing (M or P); motors are numbered 1 to 2 without a "
      "gap");
}

TEST(Notation, PrintsARatioInLowestTerms) {
  EXPECT_EQ(to_word(parse_routing("M-W1+1x-W1/12.5:20-2x")), "M-W1+1x-W1/5:8-2x");
  EXPECT_EQ(to_word(parse_routing("M-W1+1x-W1/3:3-2x")), "M-W1+1x-W1-2x");
  EXPECT_EQ(to_word(parse_routing("M-W1+1x-W1/1.001:1-2x")), "M-W1+1x-W1/1001:1000-2x");
}

TEST(NotationError, PartsOfABlockThatAreMissing) {
  expect_fault("F-1-Y1-2-F", 5,
               "block Y1 has no tail, so nothing holds it against the strands that pass it: Y1 as "
               "the end of a walk, as in M-Y1+1x-Y1-2x");
  expect_fault("M-Y1+M-1-F", 3,
               "block Y1 has a tail but nothing pulls the other way: neither a pass (Y1 inside a "
               "walk) nor a becket (Y1k)");
  expect_fault("1x-W1-2x", 4,
               "bar W1 has arms but nothing at its pivot: W1 as the end of a "
               "walk, as in M-W1+1x-W1-2x");
  expect_fault("M-W1+1x-W1+2x-M", 3,
               "bar W1 has a pivot but no arms: they are its neighbours inside a walk, as in "
               "1x-W1-2x");
}

TEST(NotationError, BlocksThatHangOnThemselves) {
  const auto hangs = [](const std::string& name) {
    return name + " hangs on itself: its tail is pulled by a tendon that " + name.substr(6) +
           " carries, directly or over other blocks";
  };
  expect_fault("Y1-1-Y1-2x+M-F", 1, hangs("block Y1"));
  expect_fault("M-1-F+Y1-Y1k", 7, hangs("block Y1"));
  expect_fault("Y1-Y2-1x+Y2-Y1-2x", 1, hangs("block Y1"));
}

// The stretch between both passes is inside the block.
TEST(NotationError, BlocksThatAWalkMeetsTwiceWithNothingBetween) {
  for (const auto& [word, column] :
       {std::pair{"M-Y1-Y1k+Y1-1x", 6}, {"M-Y1-Y1-F+Y1-1x", 6}, {"Y1k-Y1-M+Y1-1x", 5}}) {
    const std::string text = word;
    const std::string first = text.starts_with("M") ? "Y1" : "Y1k";
    const std::string second = text.find("-Y1k") != std::string::npos ? "Y1k" : "Y1";
    expect_fault(text, column,
                 "from '" + first + "' straight to '" + second +
                     "' a tendon pulls block Y1 against itself: B, T, P or a finger is needed "
                     "between, as in M-Y1-B-Y1k");
  }
  EXPECT_NO_THROW(parse_routing("M-Y1-B-Y1k+Y1-1x"));
  EXPECT_NO_THROW(parse_routing("M-Y1-Y2-F+Y1-1x+Y2-2x"));
}

TEST(NotationError, NumbersOfBlocksAndBars) {
  const std::string range = " number from 1 to 32 behind ";
  expect_fault("M-Y0", 3, "'Y0': expected a block" + range + "Y");
  expect_fault("M-Y33k", 3, "'Y33k': expected a block" + range + "Y");
  expect_fault("M-W01", 3, "'W01': expected a bar" + range + "W");
  expect_fault("M-Y-1x", 3, "unknown token 'Y'" + expected_tokens);
}

TEST(NotationError, SuffixesOfBlocksAndBars) {
  expect_fault("M-Y1b", 3, "'Y1b': expected behind the block number nothing, or k for a becket");
  expect_fault("M-Y1/2:1+1x-Y1-2x", 3,
               "'Y1/2:1': expected Y1 alone: a wrap angle belongs to a finger, T, B, P or a block "
               "inside a walk");
  expect_fault("M-W1/2:1+1x-W1-2x", 3,
               "'W1/2:1': expected W1 alone: the end of a walk is tied to the bar's pivot, and a "
               "ratio belongs to its arms");
  for (const std::string ratio : {"/2", "/0:1", "/1:-1", "/1:nan", "/1e3:1", "/1:2:3", "/", "b",
                                  "/1:0.0001", "/9999.999:1", "/1:9999.999"}) {
    const std::string word = "M-W1+1x-W1" + ratio + "-2x";
    EXPECT_NE(message(word).find("column 9: "), std::string::npos) << message(word);
  }
}

TEST(NotationError, AnchoredTipsAndBecketsStandAtEnds) {
  const std::string inside = " ends a walk and cannot stand inside it; join tendons with +";
  expect_fault("M-1x-T-2-F", 3, "'1x'" + inside);
  expect_fault("M-Y1k-1x", 3, "'Y1k'" + inside);
  expect_fault("1x-2-F", 4, "between two fingers a join is needed: T, B, P or a block before '2'");
  expect_fault("M-1x-P-F", 3, "'1x'" + inside);
}

TEST(NotationError, APlateHasThreeTies) {
  const std::string why =
      ": a rigid plate balances one force and two moments, which leave the tensions of four ties "
      "undetermined; three bars determine them, as in 1x-W1-2x+3x-W2-4x+W1-W3-W2+W3-M";
  expect_fault("M-W1+1x-W1-2x+3x-W1-F", 18, "'W1'" + why);
  expect_fault("1x-W1-2x+3x-W1k+4x-W1k+W1-M", 20, "'W1k'" + why);
  expect_fault("1x-W1-2x+3x-W1k+4x-W1-5x+W1-M", 20, "'W1'" + why);
  expect_fault("M-W1+3x-W1k", 9,
               "'W1k' is the third tie of a plate without the other two: they are the neighbours "
               "of W1 inside a walk, as in 1x-W1-2x");
  expect_fault(
      "M-W1+1x-W1-W1k", 12,
      "'W1k' lies on a tendon at the arms of bar W1, which pulls the plate against itself: "
      "the third tie needs a tendon of its own, as in M-W1+1x-W1-2x+3x-W1k");
  expect_fault("1x-W1-2x+3x-W1k", 13,
               "bar W1 has arms but nothing at its pivot: W1 as the end of a walk, as in "
               "M-W1+1x-W1-2x");
  expect_fault("1x-W1-2x+W1k-W1k+M-W1", 14, "'W1k'" + why);
  expect_fault("1x-W1-2x+W1k+M-W1", 10,
               "a walk must begin and end with M, F, a fingertip (1x) or a block (Y1), or come "
               "back to the finger that it began with, and 'W1k' does neither");
  std::string bars;
  for (int bar = 2; bar <= max_blocks; ++bar) bars += "+M-W" + std::to_string(bar);
  const std::string many = message("1x-W1-2x+3x-W1k+W1-M" + bars);
  EXPECT_NE(many.find("column 13: 'W1k': a plate counts as two bars, and there are more than 32"),
            std::string::npos)
      << many;
  expect_fault("M-W1k-1x", 3, "'W1k' ends a walk and cannot stand inside it; join tendons with +");
}

TEST(NotationError, ABarHasTwoArms) {
  expect_fault("M-W1+1-W1/2:1-1", 8,
               "'W1/2:1': a loop that is tied to both arms of a bar needs equal arms");
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
  expect_fault("M-1-X-2-F", 5, "unknown token 'X'" + expected_tokens);
  expect_fault("m-1-F", 1, "unknown token 'm'" + expected_tokens);
  expect_fault("M-1-TT-2-F", 5, "unknown token 'TT'" + expected_tokens);
  expect_fault("M - 1-F", 1, "unknown token 'M '" + expected_tokens);
  expect_fault("-1-F", 1, "an empty token" + expected_tokens);
}

TEST(NotationError, UnknownSuffixOfAFinger) {
  expect_fault("M-1c-F", 3,
               "'1c': expected behind the finger number no suffix (tube at the "
               "fingertip), b (bearing), x (the tendon is tied there) or e (tied on the back: an "
               "extensor)");
}

TEST(NotationError, MoreThanTwoStrandsOfAFinger) {
  const auto fault = [](const std::string& what) {
    return "finger 1 " + what +
           ": it has two strands; expected it passed once, or two tied ends: 1x and 1x (flexors), "
           "or 1x and 1e (an extensor)";
  };
  const std::string twice = fault("is passed twice");
  expect_fault("M-1-T-1-F", 7, twice);
  expect_fault("M-1-F+M-1-F", 9, twice);
  expect_fault("1-P-2-T-1-T-1", 9, twice);
  expect_fault("M-1-F+M-1x", 9, fault("is passed and tied"));
  expect_fault("M-1e+M-1-F", 8, fault("is passed and tied"));
  expect_fault("M-1x+M-1x+M-1e", 13, fault("has three tied ends"));
  expect_fault("M-1e+M-1e", 8, fault("has two extensors"));
  std::string many = "M-1x+M-1x";
  for (int f = 2; f <= 6; ++f) many += fmt::format("+M-{0}x+M-{0}e", f);
  EXPECT_NE(message(many).find("more than 5 fingers have two tied ends"), std::string::npos);
}

TEST(Notation, TakesBlanksAroundAWord) {
  EXPECT_EQ(parse_routing("  M-1-F\t"), parse_routing("M-1-F"));
  EXPECT_EQ(message("  M -1-F "), message("M -1-F"));
  EXPECT_EQ(message("  "), message(""));
}

TEST(NotationError, FingerNumberOutOfRange) {
  const std::string range = "expected a finger number from 1 to 64";
  expect_fault("M-0-F", 3, "'0': " + range);
  expect_fault("M-01-F", 3, "'01': " + range);
  expect_fault("M-65-F", 3, "'65': " + range);
  expect_fault("M-99999999999999999999b-F", 3, "'99999999999999999999b': " + range);
}

TEST(NotationError, FingerGap) {
  EXPECT_EQ(message("M-1-T-3-F"),
            "routing 'M-1-T-3-F': finger 2 is missing; fingers are numbered 1 to 3 without a gap");
  EXPECT_EQ(message("M-2-F"),
            "routing 'M-2-F': finger 1 is missing; fingers are numbered 1 to 2 without a gap");
}

TEST(NotationError, MissingEnd) {
  expect_fault("M-1", 3, needs_ends + "'1' does neither");
  expect_fault("1-T-2-F", 1, needs_ends + "'1' does neither");
  expect_fault("1-P-2", 1, needs_ends + "'1' does neither");
  expect_fault("M-1-F+2-T", 7, needs_ends + "'2' does neither");
  expect_fault("P", 1, needs_ends + "'P' does neither");
  expect_fault("1", 1, needs_ends + "'1' does neither");
  expect_fault("T-1-T", 1, needs_ends + "'T' does neither");
}

TEST(NotationError, OneEndAlone) {
  expect_fault("M", 1, "the walk has one token: a second end is missing");
  expect_fault("M-1-F+F", 7, "the walk has one token: a second end is missing");
}

TEST(NotationError, AdjacentFingers) {
  expect_fault("M-1-2-F", 5, "between two fingers a join is needed: T, B, P or a block before '2'");
  expect_fault("1-1", 3, "between two fingers a join is needed: T, B, P or a block before '1'");
}

TEST(NotationError, EndInsideAWalk) {
  const std::string inside = " ends a walk and cannot stand inside it; join tendons with +";
  expect_fault("M-1-M-2-F", 5, "'M'" + inside);
  expect_fault("1-F-1", 3, "'F'" + inside);
}

TEST(NotationError, LoopThatComesBackToAnotherTip) {
  expect_fault("1-T-2-P-1b", 9,
               "the loop begins with '1' and comes back to '1b': expected the same token");
}

TEST(NotationError, EmptyTokens) {
  const std::string empty = "an empty token" + expected_tokens;
  expect_fault("M-1-F+", 7, empty);
  expect_fault("+M-1-F", 1, empty);
  expect_fault("M--1-F", 3, empty);
  expect_fault("M-1-F-", 7, empty);
  expect_fault("-", 1, empty);
}

TEST(NotationError, BytesThatCannotBePrintedAreShownAsQuestionMarks) {
  const std::string shown(4, '?');
  EXPECT_EQ(message(std::string("M-\x01\x1b\0\x7f-F", 8)),
            at("M-" + shown + "-F", 3, "unknown token '" + shown + "'" + expected_tokens));
  EXPECT_EQ(message("M\n-F"), at("M?-F", 1, "unknown token 'M?'" + expected_tokens));
}

TEST(NotationError, LettersOutsideAsciiAreShownAsTheyAre) {
  expect_fault("M-é-F", 3, "unknown token 'é'" + expected_tokens);
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
  EXPECT_EQ(
      parts("M-1-Q"),
      "routing 'M-1-Q', column 5 | unknown token | Q | M, F, T, B, P, a finger such as 1, 2b or 3x, a "
      "block such as Y1 or Y1k, or a bar such as W1");
  EXPECT_EQ(parts("M-65-F"), "routing 'M-65-F', column 3 |  | 65 | a finger number from 1 to 64");
  EXPECT_EQ(
      parts("M-1-1-F"),
      "routing 'M-1-1-F', column 5 | between two fingers a join is needed: T, B, P or a block before "
      "'1' | - | ");
}

}  // namespace
}  // namespace reeve
