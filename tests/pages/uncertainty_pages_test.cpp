// Bands and sweeps as a reader sees them: marks against the numbers at the ticks.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "drawing/chart/chart.hpp"
#include "pages/exploration/exploration_figures.hpp"
#include "pages/objective_plot.hpp"
#include "pages/sweep_figures.hpp"
#include "tests/pages/explored.hpp"
#include "tests/support/read_chart.hpp"

namespace reeve::testing {
namespace {

constexpr std::array<Objective, 2> both_means{Objective::uniformity_mean,
                                              Objective::efficiency_mean};

BandedSpot banded_spot(double x, double y) {
  return {x,
          y,
          {{Objective::uniformity_mean, {x, x - 0.1, x + 0.05}},
           {Objective::efficiency_mean, {y, y - 0.2, y + 0.1}}},
          "design"};
}

TEST(BandLayers, AreBarsBothWaysThroughTheSpot) {
  chart::Panel panel;
  panel.layers = band_bars({banded_spot(0.5, 0.4)}, both_means, {}).layers;
  ASSERT_EQ(panel.layers.size(), 2U);
  const auto& across = std::get<chart::Spans>(panel.layers[0].marks);
  const auto& up = std::get<chart::Spans>(panel.layers[1].marks);
  EXPECT_EQ(across.along, chart::Along::x);
  EXPECT_EQ(across.spans[0].at, 0.4);
  EXPECT_EQ(across.spans[0].low, 0.4);
  EXPECT_EQ(across.spans[0].high, 0.55);
  EXPECT_EQ(up.along, chart::Along::y);
  EXPECT_EQ(up.spans[0].at, 0.5);
  EXPECT_NEAR(up.spans[0].low, 0.2, 1e-12);
  EXPECT_EQ(up.spans[0].high, 0.5);
  EXPECT_EQ(across.spans[0].title, "design\nuniformity mean: 0.500 (0.400–0.550)");
}

TEST(BandLayers, AreFewAndNoneWhereThereIsNoBand) {
  std::vector<BandedSpot> many;
  for (int i = 0; i < 50; ++i) many.push_back(banded_spot(0.01 * i, 0.5));
  many.push_back(banded_spot(0, 0.5));  // on the first
  EXPECT_EQ(std::get<chart::Spans>(band_bars(many, both_means, {}).layers[0].marks).spans.size(),
            most_banded);
  EXPECT_TRUE(band_bars({{0.5, 0.5, {}, "design"}}, both_means, {}).layers.empty());
  EXPECT_EQ(band_caption({}), "");
  BandedSpot point = banded_spot(0.5, 0.5);
  point.bands[1].band = {0.5, 0.5, 0.5};
  EXPECT_EQ(band_bars({point}, both_means, {}).layers.size(), 1U);
  // Sheaths have no band.
  EXPECT_EQ(band_bars({point}, {Objective::sheaths, Objective::uniformity_mean}, {}).layers.size(),
            1U);
}

// Points 0.02 apart under bars of 0.15 and 0.3.
TEST(BandBars, LeaveThePointsApart) {
  const std::vector<BandedSpot> close{banded_spot(0.5, 0.4), banded_spot(0.52, 0.42)};
  PointsSpan points;
  for (const BandedSpot& spot : close) {
    points[0].add(spot.x);
    points[1].add(spot.y);
  }
  const BandBars bars = band_bars(close, both_means, points);
  EXPECT_TRUE(bars.cut);
  EXPECT_NE(band_caption(bars).find("end where the plot does"), std::string::npos);
  const chart::Span& first = std::get<chart::Spans>(bars.layers[0].marks).spans[0];
  EXPECT_NEAR(first.low, 0.49, 1e-12);
  EXPECT_NEAR(first.high, 0.53, 1e-12);
  EXPECT_EQ(first.title, "design\nuniformity mean: 0.500 (0.400–0.550)");
  points[0].add(0.1);
  points[0].add(0.9);
  points[1].add(0);
  points[1].add(1);
  const BandBars whole = band_bars(close, both_means, points);
  EXPECT_FALSE(whole.cut);
  EXPECT_EQ(std::get<chart::Spans>(whole.layers[0].marks).spans[0].high, 0.55);
  EXPECT_EQ(band_caption(whole).find("end where the plot does"), std::string::npos);
}

TEST(ExplorationFigure, HasBarsOfTheFrontAndKnownRoutingsOnly) {
  ExploreReport report = explored(small_options());
  std::size_t with_bars = 0;
  const auto bars = [&] {
    const std::vector<PageDesign> designs = page_designs(report, 1000);
    const LiveFigure figure =
        pareto_figure(designs, {Objective::uniformity_mean, Objective::efficiency_mean});
    with_bars = 0;
    for (const PageDesign& design : designs) {
      if (design.kind == DesignKind::front || design.kind == DesignKind::known) ++with_bars;
    }
    return read_chart(figure.figure.svg).front().marks("spans").size();
  };
  EXPECT_EQ(bars(), 0U);
  for (ListedDesign& design : report.top) {
    design.bands = banded_spot(value(design.ranked.design.values, both_means[0]),
                               value(design.ranked.design.values, both_means[1]))
                       .bands;
  }
  EXPECT_GT(bars(), 4U);
  EXPECT_LE(bars(), 2 * with_bars);
}

TEST(BandColumns, AreOfTheRankedObjectives) {
  std::vector<PageDesign> designs(2);
  designs[0].bands = banded_spot(0.5, 0.4).bands;
  const Json columns = band_columns(
      designs, {Objective::sheaths, Objective::uniformity_mean, Objective::efficiency_mean},
      {Objective::uniformity_mean});
  ASSERT_EQ(columns.size(), 3U);
  EXPECT_TRUE(columns[0].is_null());
  EXPECT_EQ(columns[1].dump(), R"({"low":[0.4,null],"high":[0.55,null]})");
  EXPECT_TRUE(columns[2].is_null());
}

SweptDesigns swept_lines() {
  SweptDesigns swept;
  swept.sweep.over = {Coefficient::sheath_mu, {0.1, 0.3}};
  swept.sweep.at = {0.1, 0.2, 0.3};
  for (const char* word : {"M-1-T-2-F", "1-P-2-P-1", "F-1-P-2-F"}) {
    swept.designs.emplace_back();
    swept.designs.back().ranked.design.word = word;
  }
  // The first and the last lie on each other.
  for (const double by : {0.0, 0.3, 0.0}) {
    swept.sweep.designs.push_back(
        {{Objective::efficiency_mean,
          {0.5 - by, 0.4 - by / 2, 0.3},
          {{0.5, 0.4 - by, 0.6 - by}, {0.4, 0.3 - by, 0.5 - by}, {0.3, 0.2, 0.4}}}});
    swept.sweep.places.push_back({1, 1, 1});
  }
  swept.sweep.leads = {{0.1, 0.25, {0, 2}}, {0.25, 0.3, {1}}};
  return swept;
}

TEST(SweepFigure, HasALineAndARibbonForEachCurveAndARuleForEachCrossing) {
  const std::vector<Figure> figures = sweep_figures(swept_lines());
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].id, "sweep-efficiency-mean");
  const ReadPanel panel = read_chart(figures[0].svg).front();
  EXPECT_EQ(panel.marks("paths").size(), 2U);
  EXPECT_EQ(panel.marks("ribbons").size(), 2U);
  const std::vector<ReadMark> rules = panel.marks("rules");
  ASSERT_EQ(rules.size(), 1U);
  EXPECT_NEAR(panel.x_of(rules[0]), 0.25, 1e-3);
  EXPECT_EQ(
      rules[0].title,
      "M-1-T-2-F and F-1-P-2-F, which are equal, come first from 0.1 to 0.25\n1-P-2-P-1 comes first "
      "from 0.25 to 0.3");
  for (const char* label : {"M-1-T-2-F, F-1-P-2-F", "1-P-2-P-1"}) {
    EXPECT_EQ(panel.marks("paths", label).size(), 1U) << label;
  }
}

// A ribbon's own, even where only its upper edge is another one.
TEST(SweepFigure, DrawsCurvesApartWhoseRibbonsAreAndReachesFromTheirLowToTheirHigh) {
  SweptDesigns swept = swept_lines();
  for (Band& band : swept.sweep.designs[2][0].bands) band.high = 0.9;
  const ReadPanel panel = read_chart(sweep_figures(swept)[0].svg).front();
  EXPECT_EQ(panel.marks("ribbons").size(), 3U);
  const ReadMark ribbon = panel.marks("ribbons", "F-1-P-2-F").at(0);
  EXPECT_NEAR(panel.y_of(ribbon), (3 * 0.9 + 0.4 + 0.3 + 0.2) / 6, 1e-3);  // of its corners
}

TEST(SweepFigure, DashesTheCurvesForWhichColoursAreUsedUp) {
  SweptDesigns swept = swept_lines();
  for (int more = 0; more < 8; ++more) {
    swept.designs.push_back(swept.designs[0]);
    swept.designs.back().ranked.design.word = "D" + std::to_string(more);
    swept.sweep.designs.push_back(swept.sweep.designs[0]);
    swept.sweep.designs.back()[0].values[0] = 0.6 + 0.02 * more;
  }
  std::size_t dashed = 0;
  const ReadPanel panel = read_chart(sweep_figures(swept)[0].svg).front();
  for (const ReadGroup& group : panel.groups) {
    if (group.kind == "paths" && group.attributes.find("dasharray") != std::string::npos) ++dashed;
  }
  EXPECT_EQ(dashed, std::min<std::size_t>(panel.marks("paths").size(), studies::most_swept) - 7);
}

TEST(SweepFigure, HasNoRibbonWithoutDraws) {
  SweptDesigns swept = swept_lines();
  for (auto& curves : swept.sweep.designs) curves[0].bands.clear();
  const ReadPanel panel = read_chart(sweep_figures(swept)[0].svg).front();
  EXPECT_EQ(panel.marks("paths").size(), 2U);
  EXPECT_TRUE(panel.marks("ribbons").empty());
  EXPECT_TRUE(sweep_figures({}).empty());
  EXPECT_EQ(sweep_html({}, {}), "");
}

// From 1 to 2 high, a gap, then alone: closed areas whose corners are those of the data.
TEST(Ribbons, RunAlongTheUpperBoundAndBackAlongTheLower) {
  const double missing = std::numeric_limits<double>::quiet_NaN();
  chart::Panel panel;
  panel.x.reaches = {0, 4};
  panel.y.reaches = {0, 4};
  chart::Ribbon ribbon{
      {{0, 1, 2, ""}, {1, 1, 3, ""}, {2, missing, 3, ""}, {3, 0, 4, ""}, {4, 1, 4, ""}}, "hint"};
  panel.layers = {{"band", {}, chart::Ribbons{{ribbon}}}};
  chart::Chart chart;
  chart.width = 400;
  chart.height = 400;
  chart.panels = {panel};
  const std::string svg = chart_svg(chart);
  const std::size_t at = svg.find("<path", svg.find("reeve-ribbons"));
  ASSERT_NE(at, std::string::npos);
  const std::string path = svg.substr(at, svg.find("</path>", at) - at);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'Z'), 2);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'L'), 6);
  EXPECT_NE(path.find("<title>hint</title>"), std::string::npos);
}

}  // namespace
}  // namespace reeve::testing
