#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "core/text.hpp"
#include "reports/document/document.hpp"
#include "reports/document/text_width.hpp"
#include "tests/support/has.hpp"

namespace reeve {
namespace {

std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, text_width(line));
  return widest;
}

Table designs() {
  return {{number_column("rank"), text_column("routing"), number_column("uniformity"),
           number_column("sheaths", "", 1), number_column("knots", "", 2)},
          {{{"1", "1-P-2-P-1", "0.998", "4", "1"}}, {{"2", "F-1-P-2-F", "0.567", "2", "0"}}}};
}

TEST(TextTable, AlignsNumbersToTheRightAndTextsToTheLeft) {
  Table table{{text_column("name"), number_column("value")}, {}};
  table.add({"a", "1.25"});
  table.add({"longer", "100"});
  EXPECT_EQ(text(table),
            "name    value\n"
            "a        1.25\n"
            "longer    100\n");
}

TEST(TextTable, CountsCodePointsAndNotBytes) {
  Table table{{text_column("range"), number_column("5–95 %")}, {}};
  table.add({"ä–ö", "1"});
  table.add({"abcd", "–"});
  EXPECT_EQ(text(table),
            "range  5–95 %\n"
            "ä–ö         1\n"
            "abcd        –\n");
}

TEST(TextTable, LeavesNoSpacesAtTheEndsOfLines) {
  Table table{{number_column("number"), text_column("text")}, {}};
  table.add({"1", "a long text"});
  table.add({"2", ""});
  EXPECT_EQ(text(table),
            "number  text\n"
            "     1  a long text\n"
            "     2\n");
}

TEST(TextTable, WithoutRowsIsItsHeadings) {
  EXPECT_EQ(text(Table{{text_column("a"), number_column("b")}, {}}), "a  b\n");
}

TEST(TextTable, LeavesOutTheMostDispensableColumnsOfANarrowWindowAndSaysSo) {
  EXPECT_EQ(text(designs(), {36, false}),
            "rank  routing    uniformity  sheaths\n"
            "   1  1-P-2-P-1       0.998        4\n"
            "   2  F-1-P-2-F       0.567        2\n"
            "Left out for want of room: knots. A\n"
            "wider window and --format json have\n"
            "all.\n");
  EXPECT_TRUE(testing::has(text(designs(), {27, false}), "of room:\nsheaths, knots."));
}

TEST(TextTable, LeavesNothingOutOfAWideEnoughWindow) {
  EXPECT_EQ(text(designs(), {43, false}), text(designs()));
}

TEST(TextTable, WrapsTextsAtWords) {
  Table table{{text_column("name"), text_column("meaning")}, {}};
  table.add({"jams", "grasps in which the carriage is blocked"});
  EXPECT_EQ(text(table, {24, false}),
            "name  meaning\n"
            "jams  grasps in which\n"
            "      the carriage is\n"
            "      blocked\n");
}

TEST(TextTable, GoesOnBelowWithItsFirstColumn) {
  Table table{{text_column("held"), number_column("T1"), number_column("T2"), number_column("T3")},
              {}};
  table.add({"none", "0.125", "0.250", "0.500"});
  EXPECT_EQ(text(table, {18, false}),
            "held     T1     T2\n"
            "none  0.125  0.250\n"
            "\n"
            "held     T3\n"
            "none  0.500\n");
}

TEST(TextTable, LeavesNothingOutIfItMustGoOnBelowAnyway) {
  const std::string narrow = text(designs(), {20, false});
  EXPECT_TRUE(testing::has(narrow, "knots\n"));
  EXPECT_FALSE(testing::has(narrow, "Left out"));
}

TEST(TextTable, IsNeverWiderThanTheWindow) {
  Table table = designs();
  table.add({"3", "M-1b-B-2b-F+M-3-T-4-M", "0.1", "1", "0"});
  for (std::size_t width = 12; width < 70; ++width) {
    EXPECT_LE(widest_line(text(table, {width, false})), width);
  }
}

TEST(TextTable, ColoursLinesAroundTheSameText) {
  Table table{{text_column("status")}, {}};
  table.add({"agrees"});
  table.add({"differs"}, Tint::bad);
  EXPECT_EQ(text(table, {0, true}), "\x1b[1mstatus\x1b[0m\nagrees\n\x1b[31mdiffers\x1b[0m\n");
  EXPECT_EQ(text(table), "status\nagrees\ndiffers\n");
}

TEST(WrappedWords, BreakAtSpacesAndLongOnesAtTheirJoints) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(wrap_words("one two three", 7), (Lines{"one two", "three"}));
  EXPECT_EQ(wrap_words("as M-1-P-2-F", 6), (Lines{"as", "M-1-P-", "2-F"}));
  EXPECT_EQ(wrap_words("μμμμμ", 2), (Lines{"μμ", "μμ", "μ"}));
  EXPECT_EQ(wrap_words("a  b", 0), (Lines{"a  b"}));
  EXPECT_EQ(wrap_words("", 5), (Lines{""}));
}

TEST(FixedDecimals, RoundAndShowADashWhereThereIsNoNumber) {
  EXPECT_EQ(fixed(0.12345), "0.123");
  EXPECT_EQ(fixed(2, 0), "2");
  EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN()), "-");
  EXPECT_EQ(fixed(std::numeric_limits<double>::infinity()), "-");
}

}  // namespace
}  // namespace reeve
