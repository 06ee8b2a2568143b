#include "reports/compare_report.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/output/json.hpp"

namespace reeve::testing {
namespace {

using Cells = std::vector<std::string>;

// Residuals cancel but for rounding.
CompareReport report_of_many_runs() {
  CompareReport report;
  report.comparison.tension.all = {"all", 4, 8, -0.5, 2, 0.25};
  report.comparison.tension.by_run.assign(22, {"A", 1, std::nan(""), 1e-15, 2, std::nan("")});
  return report;
}

TEST(CompareDocument, HasAColumnForEachFigureAndTheFirstGroupsOfAKind) {
  const Document document = compare_sheet(report_of_many_runs());
  ASSERT_EQ(document.sections.size(), 2U);
  const std::vector<TableRow>& rows = document.sections[1].table->rows;
  ASSERT_EQ(rows.size(), 22U);
  EXPECT_EQ(rows[0].cells, (Cells{"all", "all", "4", "8", "-0.5", "2", "25.0 %"}));
  EXPECT_EQ(rows[20].cells, (Cells{"run", "A", "1", "-", "0", "2", "-"}));
  EXPECT_EQ(rows[21].cells, (Cells{"run", "… 2 more", "", "", "", "", ""}));
}

TEST(CompareJson, HasEveryFigureOfEveryGroup) {
  const Json json = Json::parse(compare_json(report_of_many_runs()));
  EXPECT_EQ(json["tension"]["by_run"].size(), 22U);
  const Json expected{{"group", "all"},        {"count", 4}, {"mean_measured", 8.0},
                      {"mean_residual", -0.5}, {"rms", 2.0}, {"relative_rms", 0.25}};
  EXPECT_EQ(json["tension"]["all"], expected);
  EXPECT_TRUE(json["share"].is_null());
}

}  // namespace
}  // namespace reeve::testing
