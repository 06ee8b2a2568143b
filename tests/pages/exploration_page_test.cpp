#include "pages/exploration_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "pages/chart_engine.hpp"
#include "pages/exploration_designs.hpp"
#include "tests/pages/explored.hpp"

namespace reeve {
namespace {

using testing::explored;
using testing::small_options;

constexpr const char* charts = "exploration_charts.js";

// The JSON that the page's script finds.
Json page_data(const std::string& html) {
  const std::string opening = "id=\"page-data\">";
  const std::size_t begin = html.find(opening) + opening.size();
  return Json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

std::set<std::string> detailed_words(const std::string& html) {
  std::set<std::string> words;
  const Json data = page_data(html);
  for (const Json& chunk : data["chunks"]) {
    for (const Json& word : chunk["words"]) words.insert(word.get<std::string>());
  }
  return words;
}

TEST(ExplorationPage, HasDetailsOfAllDesignsOfASmallList) {
  const ExploreReport report = explored(small_options());
  const PageFiles page = exploration_page(testing::view(report));
  EXPECT_EQ(detailed_words(page.html).size(), 54U);
  EXPECT_NE(page.html.find("54 of 54 ranked designs are listed"), std::string::npos);
  EXPECT_LT(page.html.size(), 1'300'000U);
}

TEST(ExplorationPage, WritesItsPicturesAsFiles) {
  const PageFiles page = exploration_page(testing::view(explored(small_options())));
  std::set<std::string> ids;
  for (const FigureFile& file : page.figures) {
    EXPECT_TRUE(file.svg.starts_with("<svg ")) << file.id;
    EXPECT_TRUE(ids.insert(file.id).second) << file.id;
  }
  for (const char* id : {"pareto", "parallel", "schematic-1-P-2-P-1", "schematic-M-1-T-2-F"}) {
    EXPECT_TRUE(ids.contains(id)) << id;
  }
}

TEST(ExplorationPage, IsTheSameForAnyNumberOfThreads) {
  ExploreOptions options = small_options(3);
  const std::string one = exploration_page(testing::view(explored(options))).html;
  options.threads = 2;
  EXPECT_TRUE(exploration_page(testing::view(explored(options))).html == one);
}

TEST(ExplorationPage, EscapesWhatUsersWrote) {
  ExploreReport report = explored(small_options());
  const std::string hostile = "</script><script>alert(1)</script>\"'&";
  report.top.front().name = hostile;
  report.front.front().name = hostile;
  report.reference_names.back() = hostile;
  ExplorationView view = testing::view(report);
  view.command = "reeve explore --hardware '" + hostile + "'";
  view.show_options = " --hardware '" + hostile + "'";
  view.solve = [&report, hostile](const std::string& word) {
    ShowReport shown = testing::view(report).solve(word);
    shown.name = hostile;
    return shown;
  };
  const PageFiles page = exploration_page(view);
  EXPECT_EQ(page.html.find("<script>alert"), std::string::npos);
  EXPECT_NE(page.html.find("&lt;script&gt;alert"), std::string::npos);
  EXPECT_EQ(page_data(page.html)["commands"]["options"], view.show_options);
}

TEST(ExplorationPage, SaysThatItIsPartial) {
  ExploreReport report = explored(small_options());
  report.result.partial = true;
  report.result.total = 1000;
  const PageFiles page = exploration_page(testing::view(report));
  EXPECT_NE(page.html.find("This exploration is partial: stopped after 126 of 1000 routings"),
            std::string::npos);
}

TEST(ExplorationPage, IsMadeEvenIfNothingIsLeft) {
  ExploreOptions options = small_options();
  options.constraints.push_back(parse_constraint("sheaths<=0"));
  const PageFiles page = exploration_page(testing::view(explored(options)));
  EXPECT_NE(page.html.find("No design is left to rank"), std::string::npos);
  EXPECT_EQ(page.html.find("id=\"bests\""), std::string::npos);
}

TEST(ExplorationPage, StaysBelowFiveMegabytesWithAHundredThousandDesigns) {
  const ExploreReport report = testing::large(100'000);
  const ShowReport shown = cli::shown_routing(parse_routing("1b-P-2b-P-3b-P-1b+4-P-5-P-4"), {},
                                              single_grasps(5), Direction::pull, Catalogue{});
  std::size_t solved = 0;
  const SolveDesign solve = [&](const std::string& word) {
    ShowReport own = shown;
    own.word = word;
    // Noise, so that designs are as unlike as real ones are, and more.
    for (ShownGrasp& grasp : own.grasps) {
      for (double& tension : grasp.state.tension) {
        tension *= static_cast<double>(1 + ++solved % 997) / 500;
      }
    }
    return own;
  };
  const PageFiles page = exploration_page({report, "reeve explore", "", solve});
  EXPECT_LT(page.html.size(), 5'000'000U);
  EXPECT_GT(page.html.size(), 3'000'000U);  // it does not give up room that it has
  EXPECT_GT(detailed_words(page.html).size(), 100U);
  EXPECT_LT(detailed_words(page.html).size(), 100'000U);
  EXPECT_NE(page.html.find("For the others the page gives the values"), std::string::npos);
  EXPECT_NE(page.html.find("; this page holds the first "), std::string::npos);
  for (const FigureFile& file : page.figures) EXPECT_LT(file.svg.size(), 1'500'000U) << file.id;
}

TEST(DesignColumns, HoldEachDesignOnce) {
  ExploreOptions options = small_options();
  options.top = 5;
  const ExploreReport report = explored(options);
  const Json columns = design_columns(report, 5);
  std::set<std::string> words;
  for (const Json& word : columns["word"]) EXPECT_TRUE(words.insert(word).second) << word;
  EXPECT_EQ(words.size(), 54U);  // the sample is all that there is
  EXPECT_EQ(columns["kind"][0], static_cast<int>(Kind::known));
  EXPECT_EQ(columns["kind"][1], static_cast<int>(Kind::front));
  EXPECT_EQ(columns["kind"][53], static_cast<int>(Kind::sample));
  EXPECT_EQ(columns["values"].size(), objective_count);
  for (const Json& column : columns["values"]) EXPECT_EQ(column.size(), words.size());
}

Json drawn(const ExploreReport& report, int x, int y) {
  return script_value(
      charts, "explorationCharts.pareto",
      {{"data", chart_data(report, design_columns(report, 1'000'000))}, {"axes", {x, y}}});
}

std::set<int> drawn_rows(const Json& chart) {
  std::set<int> rows;
  for (const Json& layer : chart["spec"]["layer"]) {
    if (layer["data"]["name"] != "points") continue;
    for (const Json& point : layer["data"]["values"]) rows.insert(point["row"].get<int>());
  }
  return rows;
}

TEST(ParetoPlot, ThinsOutTheManyAndKeepsTheFrontWhole) {
  const ExploreReport report = testing::large(20'000);
  const Json chart = drawn(report, 0, 2);
  const std::set<int> rows = drawn_rows(chart);
  EXPECT_EQ(chart["of"], 20'000);
  EXPECT_EQ(chart["drawn"], rows.size());
  EXPECT_LT(rows.size(), 9'500U);
  for (int row = 0; row < 200; ++row) EXPECT_TRUE(rows.contains(row)) << row;
}

// Points that the line's corners must be; as [x, y].
std::vector<std::vector<double>> edge(const std::string& better_x, const std::string& better_y) {
  const Json line = script_value(charts, "(each => explorationCharts.frontLine(...each))",
                                 {{{1, 3}, {2, 2}, {3, 1}, {1.5, 1.5}, {2.5, 2.5}},
                                  {{{"better", better_x}}, {{"better", better_y}}},
                                  {{0, 4}, {0, 5}}});
  std::vector<std::vector<double>> corners;
  for (const Json& point : line) corners.push_back({point["x"], point["y"]});
  return corners;
}

TEST(FrontLine, GoesThroughWhatNoneBeatsWhicheverWayIsBetter) {
  using Corners = std::vector<std::vector<double>>;
  EXPECT_EQ(edge("higher", "higher"), (Corners{{3, 0}, {3, 1}, {2.5, 2.5}, {1, 3}, {0, 3}}));
  EXPECT_EQ(edge("lower", "lower"), (Corners{{1, 5}, {1, 3}, {1.5, 1.5}, {3, 1}, {4, 1}}));
  EXPECT_EQ(edge("higher", "lower"), (Corners{{3, 5}, {3, 1}, {0, 1}}));
  EXPECT_EQ(edge("lower", "higher"), (Corners{{1, 0}, {1, 3}, {4, 3}}));
}

TEST(FrontLine, IsDrawnOnlyWhereBothAxesAreWhatTheRankingCounts) {
  const ExploreReport report = explored(small_options());
  const auto corners = [&](int x, int y) {
    const Json chart = drawn(report, x, y);
    for (const Json& layer : chart["spec"]["layer"]) {
      if (layer["data"]["name"] == "edge") return layer["data"]["values"].size();
    }
    return std::size_t{1000};
  };
  EXPECT_EQ(corners(0, 2), 3U);
  EXPECT_EQ(corners(2, 0), 3U);
  EXPECT_EQ(corners(0, 6), 0U);
}

}  // namespace
}  // namespace reeve
