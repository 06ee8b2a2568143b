#include "reports/output/stamp.hpp"

#include <gtest/gtest.h>

#include <string>

namespace reeve {
namespace {

const Stamp stamp{"result_id", "0123456789abcdef"};

TEST(Stamp, IsTheLastFieldOfEachRecordOfATable) {
  const std::string table =
      "# a note, \"quoted\nrun,T1\n"
      "\"#1\n# in the name, \"\"B\"\"\",3\n"
      "A,4\n";
  const std::string stamped_table = stamped("a.csv", table, stamp);
  EXPECT_EQ(stamped_table,
            "# a note, \"quoted\nrun,T1,result_id\n"
            "\"#1\n# in the name, \"\"B\"\"\",3,0123456789abcdef\n"
            "A,4,0123456789abcdef\n");
  EXPECT_EQ(id_in("a.csv", stamped_table, stamp.kind), stamp.id);
  EXPECT_EQ(id_in("a.csv", stamped_table, "exploration"), "");
}

TEST(Stamp, EndsPagesAndDrawingsAndLeavesOtherTextAsItIs) {
  EXPECT_EQ(stamped("a.svg", "<svg/>\n", stamp), "<svg/>\n<!-- result_id 0123456789abcdef -->\n");
  EXPECT_EQ(id_in("a.html", stamped("a.html", "<p>\n", stamp), stamp.kind), stamp.id);
  EXPECT_EQ(stamped("a.txt", "text\n", stamp), "text\n");
}

}  // namespace
}  // namespace reeve
