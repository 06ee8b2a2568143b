#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "drawing/chart/chart.hpp"
#include "drawing/chart/chart_layout.hpp"
#include "tests/support/svg.hpp"

namespace reeve::drawing::chart {
namespace {

using testing::count;
using testing::expect_well_formed;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
const std::string hostile = "<script>\"a\" & 'b'</script>\x01";

// The group of that class, without what is around it.
std::string group(const std::string& svg, const std::string& name) {
  const std::size_t begin = svg.find("<g class=\"" + name);
  return begin == std::string::npos ? "" : svg.substr(begin, svg.find("</g>", begin) - begin);
}

Chart one_of_everything(const std::string& text) {
  Panel panel;
  panel.heading = panel.title = panel.x.title = panel.y.title = text;
  panel.x.categories = {text, "b", "c"};
  Style style;
  style.fill = 0.3;
  style.dash = Dash::dashed;
  panel.layers = {
      {text + "0", style, PanelBands{{{0, 1, 2, text}}, Along::y}},
      {text + "1", style, Bars{{{0, 3, text, ""}, {1, -2, "", ""}, {2, missing, "", ""}}, {0, 2}}},
      {text + "2", style, Spans{{{0, 1, 2, text}, {1, missing, 3, ""}}, Along::y, {1, 2}}},
      {text + "3", style, Paths{{{{{0, 1}, {1, 2}, {2, 3}}, text}}, false}},
      {text + "4", style, Points{{{0, 1, text, text}, {1, 2, "", ""}, {missing, 2, "", "gone"}}}},
      {text + "5", style, Rules{{{2.5, text, text}}, Along::y}},
      {text + "6", style, Texts{{{2, 1, "", text}}}}};
  Chart chart;
  chart.alt = text;
  chart.panels = {panel};
  return chart;
}

// As chart.hpp shows it.
TEST(ChartSvg, DrawsTheExampleOfItsHeader) {
  chart::Chart chart;
  chart.alt = "Measured over predicted tensions";
  chart::Panel panel;
  panel.x.title = "predicted, N";
  panel.y.title = "measured, N";
  chart::Style hollow{chart::series_colour(0), chart::series_symbol(0)};
  hollow.fill = 0;
  panel.layers.push_back({"TR1", hollow, chart::Points{{{1.9, 2.1, "line 7: T1", ""}}}});
  chart.panels.push_back(panel);
  const std::string svg = chart_svg(chart);
  expect_well_formed(svg);
  EXPECT_NE(group(svg, "reeve-points").find("<title>line 7: T1</title>"), std::string::npos);
}

TEST(ChartSvg, IsWellFormedWithAnyText) {
  for (const std::string& text : {std::string("plain"), hostile, std::string("µ “°C”")}) {
    const std::string svg = chart_svg(one_of_everything(text));
    expect_well_formed(svg);
    EXPECT_EQ(count(svg, "<script"), 0U);
    EXPECT_EQ(count(svg, "<svg "), 1U);
  }
}

TEST(ChartSvg, DrawsOneElementForEachMarkThatCanBeDrawn) {
  const std::string svg = chart_svg(one_of_everything("t"));
  EXPECT_EQ(count(group(svg, "reeve-bands"), "<rect"), 1U);
  EXPECT_EQ(count(group(svg, "reeve-bars"), "<rect"), 2U);
  EXPECT_EQ(count(group(svg, "reeve-spans"), "<path"), 1U);
  EXPECT_EQ(count(group(svg, "reeve-paths"), "<path"), 1U);
  EXPECT_EQ(count(group(svg, "reeve-points"), "<circle"), 2U);
  EXPECT_EQ(count(group(svg, "reeve-rules"), "<path"), 1U);
  EXPECT_EQ(count(group(svg, "reeve-texts"), "<text"), 1U);
  EXPECT_EQ(count(svg, "gone"), 0U);
}

TEST(ChartSvg, HasATooltipForEachMark) {
  const std::string svg = chart_svg(one_of_everything("t"));
  EXPECT_NE(group(svg, "reeve-points").find("<title>t</title></circle>"), std::string::npos);
  EXPECT_EQ(count(svg, "<title>t</title>"), 6U);
  const std::string lines = chart_svg(one_of_everything("a<b\nc"));
  EXPECT_EQ(count(lines, "<title>a&lt;b\nc</title>"), 6U);
}

TEST(ChartSvg, DrawsEachSymbolAndColour) {
  Chart chart;
  chart.panels.resize(1);
  for (std::size_t i = 0; i < 7; ++i) {
    Style style{static_cast<Colour>(i), static_cast<Symbol>(i)};
    chart.panels[0].layers.push_back({"s" + std::to_string(i), style, Points{{{1.0, 1, "", ""}}}});
  }
  const std::string svg = chart_svg(chart);
  expect_well_formed(svg);
  std::set<std::string> shapes;
  for (std::size_t i = 0; i < 7; ++i) {
    const std::size_t begin = svg.find("data-series=\"s" + std::to_string(i) + "\"");
    const std::size_t mark = svg.find("<", begin);
    shapes.insert(svg.substr(mark, svg.find('>', mark) - mark));
  }
  EXPECT_EQ(shapes.size(), 7U);
  EXPECT_EQ(count(svg, " color=\"#"), 1U + 2 * 6);  // the picture, and each but the ink's twice
}

TEST(ChartSvg, PutsBarsFromZeroToTheirValueSideBySide) {
  const Chart chart = one_of_everything("t");
  const LaidPanel panel = layout(chart).panels.front();
  static const std::regex bar(
      R"re(<rect x="([0-9.]+)" y="([0-9.]+)" width="([0-9.]+)" height="([0-9.]+)")re");
  const std::string bars = group(chart_svg(chart), "reeve-bars");
  std::smatch first;
  ASSERT_TRUE(std::regex_search(bars, first, bar));
  const double top = std::stod(first.str(2));
  EXPECT_NEAR(value(panel.y.scale, top), 3, 0.02);
  EXPECT_NEAR(value(panel.y.scale, top + std::stod(first.str(4))), 0, 0.02);
  // The first of two slots that share 0.8 of the category.
  EXPECT_NEAR(value(panel.x.scale, std::stod(first.str(1))), -0.4, 0.01);
  EXPECT_NEAR(value(panel.x.scale, std::stod(first.str(1)) + std::stod(first.str(3))), 0, 0.01);
}

std::string commands(const Paths& paths) {
  Chart chart;
  chart.panels.resize(1);
  chart.panels[0].x.reaches = chart.panels[0].y.reaches = {0, 4};
  chart.panels[0].layers.push_back({"", {}, paths});
  const std::string group_text = group(chart_svg(chart), "reeve-paths");
  static const std::regex path(R"re( d="([^"]*)")re");
  std::smatch found;
  return std::regex_search(group_text, found, path) ? found.str(1) : "";
}

TEST(ChartSvg, BreaksALineWhereAValueIsMissing) {
  const std::string broken =
      commands({{{{{0, 0}, {1, 1}, {2, missing}, {3, 1}, {4, 2}}, ""}}, false});
  EXPECT_EQ(count(broken, "M"), 2U);
  EXPECT_EQ(count(broken, "L"), 2U);
}

TEST(ChartSvg, StepsFirstAcrossThenUp) {
  const std::string steps = commands({{{{{0, 0}, {4, 4}}, ""}}, true});
  static const std::regex numbers(
      R"re(M([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+))re");
  std::smatch at;
  ASSERT_TRUE(std::regex_match(steps, at, numbers)) << steps;
  EXPECT_EQ(at.str(2), at.str(4));
  EXPECT_EQ(at.str(3), at.str(5));
}

TEST(ChartSvg, ShortensALongTextAndHasAllOfItInATooltip) {
  Chart chart = one_of_everything("t");
  const std::string name(300, 'x');
  chart.panels[0].title = name;
  const std::string svg = chart_svg(chart);
  EXPECT_NE(svg.find("…</text>"), std::string::npos);
  EXPECT_NE(svg.find("<title>" + name + "</title>"), std::string::npos);
}

TEST(ChartSvg, NamesItselfAndHasNoIdentifiers) {
  const std::string svg = chart_svg(one_of_everything("t"));
  EXPECT_NE(svg.find("role=\"img\" aria-label=\"t\""), std::string::npos);
  EXPECT_EQ(count(svg, " id=\""), 0U);
  EXPECT_EQ(count(svg, "url("), 0U);
}

TEST(ChartSvg, HasTheSameBytesEachTime) {
  EXPECT_EQ(chart_svg(one_of_everything("t")), chart_svg(one_of_everything("t")));
}

}  // namespace
}  // namespace reeve::drawing::chart
