// Names as rows of a CSV file have them.
#include "reports/output/csv_field.hpp"

#include <gtest/gtest.h>

namespace reeve {
namespace {

using reports::csv_field;

TEST(CsvField, IsQuotedWhereItWouldNotBeReadAsItIs) {
  EXPECT_EQ(csv_field("TR1"), "TR1");
  EXPECT_EQ(csv_field("a, b"), "\"a, b\"");
  EXPECT_EQ(csv_field("a \"b\""), "\"a \"\"b\"\"\"");
  EXPECT_EQ(csv_field("a\nb"), "\"a\nb\"");
}

// A row that begins so is a comment.
TEST(CsvField, ThatBeginsAsACommentIsQuoted) {
  EXPECT_EQ(csv_field("#1"), "\"#1\"");
  EXPECT_EQ(csv_field("A#1"), "A#1");
}

}  // namespace
}  // namespace reeve
