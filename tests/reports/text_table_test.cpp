#include "reports/text_table.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace reeve {
namespace {

TEST(TextTable, AlignsNumbersToTheRightAndMarkedColumnsToTheLeft) {
  TextTable table({"<name", "value"});
  table.add({"a", "1.25"});
  table.add({"longer", "100"});
  EXPECT_EQ(table.text(),
            "name    value\n"
            "a        1.25\n"
            "longer    100\n");
}

TEST(TextTable, CountsCodePointsAndNotBytes) {
  TextTable table({"<range", "5–95 %"});
  table.add({"ä–ö", "1"});
  table.add({"abcd", "–"});
  EXPECT_EQ(table.text(),
            "range  5–95 %\n"
            "ä–ö         1\n"
            "abcd        –\n");
}

TEST(TextTable, LeavesNoSpacesAtTheEndsOfLines) {
  TextTable table({"number", "<text"});
  table.add({"1", "a long text"});
  table.add({"2", ""});
  EXPECT_EQ(table.text(),
            "number  text\n"
            "     1  a long text\n"
            "     2\n");
}

TEST(TextTable, WithoutRowsIsItsHeadings) { EXPECT_EQ(TextTable({"<a", "b"}).text(), "a  b\n"); }

TEST(FixedDecimals, RoundAndShowADashWhereThereIsNoNumber) {
  EXPECT_EQ(fixed(0.12345), "0.123");
  EXPECT_EQ(fixed(2, 0), "2");
  EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN()), "-");
  EXPECT_EQ(fixed(std::numeric_limits<double>::infinity()), "-");
}

}  // namespace
}  // namespace reeve
