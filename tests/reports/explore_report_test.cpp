#include "reports/results/explore_report.hpp"

#include <gtest/gtest.h>

#include <string>

#include "reports/sheet/sheet_text.hpp"

namespace reeve {
namespace {

TEST(ExploreSheet, SaysWhatOrdersWithinAFrontWhereItIsTheScore) {
  ExploreReport report;
  report.options.grasps = single_grasps(2);
  EXPECT_EQ(text(explore_sheet(report)).find("the score"), std::string::npos);
  report.options.order.by_score = true;
  report.options.score = parse_score("uniformity=2");
  EXPECT_NE(text(explore_sheet(report))
                .find("Front by front over uniformity_mean, efficiency_mean, within a front by the "
                      "score, the weighted mean of uniformity_mean=2 (greater is better)\n"),
            std::string::npos)
      << text(explore_sheet(report));
}

}  // namespace
}  // namespace reeve
