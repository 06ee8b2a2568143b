#include "pages/shell/html_table.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/svg.hpp"

namespace reeve {
namespace {

TEST(HtmlTable, MarksNotableRowsOnly) {
  Table table{{text_column("what"), text_column("remark")}, {}};
  table.add({"a", ""});
  table.add({"b", "agrees"}, Tint::good);
  table.add({"c", "stands apart"}, Tint::notable);
  table.add({"d", "differs"}, Tint::bad);
  const std::string made = html({"marked", "Marked", table});
  EXPECT_EQ(testing::count(made, "notable"), 1U);
  EXPECT_NE(made.find("<tr class=\"notable\"><th scope=\"row\" class=\"left\">c<"),
            std::string::npos);
}

}  // namespace
}  // namespace reeve
