#include <gtest/gtest.h>

#include <string>

#include "reports/exploration/band_report.hpp"

namespace reeve {
namespace {

using studies::RobustDesign;
using studies::RobustFirst;

RobustDesign drawn(const std::string& word, double value, double p5) {
  RobustDesign robust;
  robust.design.ranked.design.word = word;
  robust.value = value;
  robust.p5 = p5;
  return robust;
}

TEST(RobustReport, SaysWhatEachOfTwoDesignsLoses) {
  const RobustFirst first{drawn("M-1-F", 0.5, 0.2), drawn("F-1-M", 0.4, 0.25), false, true};
  const auto lines = reports::robust_lines(first);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(
      lines[0].text,
      "Most robust design over the draws: F-1-M: 5 % quantile of uniformity x efficiency 0.250 "
      "(best: 0.200, -20.0 %); nominal 0.400 (-20.0 %)");
  const Json json = reports::robust_json(first);
  EXPECT_EQ(json["by"], "product");
  EXPECT_EQ(json["over"], "draws");
  EXPECT_EQ(json["nominal"]["routing"], "M-1-F");
  EXPECT_NEAR(json["nominal"]["loss"].get<double>(), 0.2, 1e-12);
  EXPECT_NEAR(json["robust"]["loss"].get<double>(), 0.2, 1e-12);
  EXPECT_EQ(json["robust"]["p5"], 0.25);
}

TEST(RobustReport, SaysWhereBothAreOneDesign) {
  const RobustDesign one = drawn("M-1-F", 0.5, 0.2);
  const auto lines = reports::robust_lines(RobustFirst{one, one, false, false});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(
      lines[0].text,
      "It is also the most robust design if friction differs between contacts: product of the 5 % "
      "quantiles of uniformity and efficiency 0.200, nominal 0.500");
}

TEST(RobustReport, IsEmptyWithoutDesigns) {
  EXPECT_TRUE(reports::robust_lines(std::nullopt).empty());
  EXPECT_TRUE(reports::robust_json(std::nullopt).is_null());
}

}  // namespace
}  // namespace reeve
