// The plots of an exploration without its script: which designs they show, and where.
#include "pages/exploration/exploration_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "search/evaluate/shown_objectives.hpp"
#include "tests/pages/explored.hpp"
#include "tests/support/read_chart.hpp"

namespace reeve {
namespace {

using testing::explored;
using testing::read_chart;
using testing::ReadMark;
using testing::ReadPanel;
using testing::small_options;

constexpr TwoObjectives usual{Objective::uniformity_mean, Objective::efficiency_mean};

std::vector<PageDesign> designs(const ExploreReport& report) {
  return page_designs(report, 1'000'000);
}

TEST(DrawnDesigns, AreFewOfManyButTheWholeFront) {
  const std::vector<PageDesign> all = designs(testing::large(20'000));
  const std::vector<DrawnDesign> drawn = thinned(all, usual);
  std::set<std::size_t> rows;
  std::size_t stand_for = 0;
  for (const DrawnDesign& each : drawn) {
    rows.insert(each.design);
    stand_for += each.count;
  }
  EXPECT_EQ(rows.size(), drawn.size());
  EXPECT_EQ(stand_for, 20'000U);
  EXPECT_LT(drawn.size(), 6'000U);
  for (std::size_t row = 0; row < 200; ++row) EXPECT_TRUE(rows.contains(row)) << row;
}

TEST(DrawnDesigns, AreAllKnownRoutingsEvenOnOneSpot) {
  std::vector<PageDesign> all(3);
  for (PageDesign& design : all) design.kind = DesignKind::known;
  EXPECT_EQ(thinned(all, usual).size(), 3U);
  for (PageDesign& design : all) design.kind = DesignKind::listed;
  EXPECT_EQ(thinned(all, usual).size(), 1U);
}

// The line's corners for points of which (1.5, 1.5) and (2.5, 2.5) are in the middle; as {x, y}.
std::vector<std::pair<double, double>> edge(Objective x, Objective y) {
  const std::vector<Point> front{{1, 3}, {2, 2}, {3, 1}, {1.5, 1.5}, {2.5, 2.5}};
  std::vector<Point> shown = front;
  shown.insert(shown.end(), {{0, 0}, {4, 5}});
  std::vector<std::pair<double, double>> corners;
  for (const Point& at : front_edge(front, {x, y}, shown)) corners.emplace_back(at.x, at.y);
  return corners;
}

TEST(FrontEdge, GoesThroughWhatNoneBeatsWhicheverWayIsBetter) {
  using Corners = std::vector<std::pair<double, double>>;
  const Objective higher = Objective::uniformity_mean;
  const Objective lower = Objective::sheaths;
  EXPECT_EQ(edge(higher, higher), (Corners{{3, 0}, {3, 1}, {2.5, 2.5}, {1, 3}, {0, 3}}));
  EXPECT_EQ(edge(lower, lower), (Corners{{1, 5}, {1, 3}, {1.5, 1.5}, {3, 1}, {4, 1}}));
  EXPECT_EQ(edge(higher, lower), (Corners{{3, 5}, {3, 1}, {0, 1}}));
  EXPECT_EQ(edge(lower, higher), (Corners{{1, 0}, {1, 3}, {4, 3}}));
}

std::vector<PageDesign> at_places(const std::vector<std::pair<double, double>>& places) {
  std::vector<PageDesign> all;
  for (const auto& [x, y] : places) {
    PageDesign design;
    design.word = "M-" + std::to_string(all.size() + 1) + "-F";
    value(design.values, Objective::uniformity_mean) = x;
    value(design.values, Objective::efficiency_mean) = y;
    all.push_back(design);
  }
  return all;
}

// The spread is 1 both ways and (1, 1) beats all: 0.9 is as far from it in x as in y.
TEST(AboutTheFront, IsTheFrontWithTheNearestPlaces) {
  const std::vector<std::pair<double, double>> best{{1, 1},       {0.95, 0.95}, {0.92, 0.99},
                                                    {0.99, 0.91}, {0.9, 0.93},  {0.97, 0.9},
                                                    {0.93, 0.9},  {0.9, 0.9}};
  std::vector<std::pair<double, double>> places = best;
  places.insert(places.end(), {{0, 0}, {0.95, 0.5}, {0.5, 0.95}, {0.89, 0.99}});
  const std::vector<PageDesign> near = about_the_front(at_places(places), usual);
  ASSERT_EQ(near.size(), best.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    EXPECT_EQ(value(near[i].values, Objective::uniformity_mean), best[i].first);
  }
}

TEST(AboutTheFront, ReachesAsFarAsTheFrontDoes) {
  const std::vector<std::pair<double, double>> places{
      {1, 0.5},    {0.6, 1},    {0.8, 0.8},   {0.7, 0.6}, {0.65, 0.55}, {0.61, 0.9},
      {0.75, 0.7}, {0.8, 0.55}, {0.62, 0.52}, {0, 0},     {0.55, 0.9},  {0.9, 0.45}};
  EXPECT_EQ(about_the_front(at_places(places), usual).size(), 9U);
}

TEST(AboutTheFront, IsNoneWhereHardlyAnythingLiesThere) {
  EXPECT_TRUE(about_the_front({}, usual).empty());
  EXPECT_TRUE(
      about_the_front(at_places({{1, 1}, {0.95, 0.95}, {0, 0}, {0.2, 0.1}}), usual).empty());
  const std::vector<std::pair<double, double>> same(9, {0.5, 0.5});
  EXPECT_TRUE(about_the_front(at_places(same), usual).empty());
}

TEST(ParetoFigure, HasAPanelOfItsOwnAboutTheFront) {
  const std::vector<PageDesign> all = designs(explored(small_options(3)));
  const std::vector<PageDesign> near = about_the_front(all, usual);
  ASSERT_GT(near.size(), 4U);
  ASSERT_LT(near.size(), all.size());
  const auto panels = read_chart(
      pareto_figure(all, {Objective::uniformity_mean, Objective::efficiency_mean}).figure.svg);
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(panels[0].marks("points").size(), thinned(all, usual, of_two_panels).size());
  EXPECT_EQ(panels[1].marks("points").size(), thinned(near, usual, of_two_panels).size());
}

TEST(ParetoFigure, PutsEveryMarkWhereItsDesignIs) {
  const ExploreReport report = explored(small_options());
  const std::vector<PageDesign> all = designs(report);
  std::map<std::string, const PageDesign*> by_label;
  for (const PageDesign& design : all) {
    by_label[(design.name.empty() ? "" : design.name + ": ") + design.word] = &design;
  }
  const ReadPanel panel =
      read_chart(pareto_figure(all, report.options.order.objectives).figure.svg).front();
  const std::vector<ReadMark> marks = panel.marks("points");
  EXPECT_EQ(marks.size(), thinned(all, usual).size());
  EXPECT_GT(marks.size(), 20U);
  for (const ReadMark& mark : marks) {
    const PageDesign& design = *by_label.at(mark.title.substr(0, mark.title.find('\n')));
    EXPECT_NEAR(panel.x_of(mark), value(design.values, Objective::uniformity_mean), 1e-4);
    EXPECT_NEAR(panel.y_of(mark), value(design.values, Objective::efficiency_mean), 1e-4);
  }
}

TEST(ParetoFigure, NamesTheKnownRoutingsOnce) {
  const ExploreReport report = explored(small_options());
  std::vector<PageDesign> all = designs(report);
  std::vector<PageDesign> twice;
  for (PageDesign& design : all) {
    if (design.kind != DesignKind::known) continue;
    design.name = "K" + design.word.substr(0, 1);
    twice.push_back(design);
    twice.back().name += "'";
  }
  all.insert(all.end(), twice.begin(), twice.end());
  const ReadPanel panel =
      read_chart(pareto_figure(all, report.options.order.objectives).figure.svg)[0];
  for (const char* label : {"KM, KM'", "KF, KF'", "K1, K1'"}) {  // those on one spot together
    EXPECT_EQ(std::count(panel.texts.begin(), panel.texts.end(), label), 1) << label;
  }
}

TEST(ParetoFigure, DrawsTheEdgeOnlyWhereTheRankingCountsBothAxes) {
  const ExploreReport report = explored(small_options());
  const auto edges = [&](const std::vector<Objective>& ranking) {
    return read_chart(pareto_figure(designs(report), ranking).figure.svg)
        .front()
        .marks("paths")
        .size();
  };
  EXPECT_EQ(edges({Objective::uniformity_mean, Objective::efficiency_mean}), 1U);
  EXPECT_EQ(edges({Objective::sheaths}), 0U);  // over uniformity, which does not count
}

TEST(ParetoFigure, EndsWhereUniformityDoes) {
  const ExploreReport report = explored(small_options());
  const ReadPanel panel =
      read_chart(pareto_figure(designs(report), report.options.order.objectives).figure.svg)
          .front();
  EXPECT_EQ(panel.x.back().text, "1.0");
}

TEST(ParallelFigure, HasLinesOfTheBestAndTheKnown) {
  const auto lines = [](const ExploreReport& report) {
    const ReadPanel panel =
        read_chart(
            parallel_figure(designs(report), shown_objectives({}, authors_score())).figure.svg)
            .front();
    std::set<std::string> titles;
    for (const char* kind : {"listed", "on the front", "known routing"}) {
      for (const ReadMark& mark : panel.marks("paths", kind)) titles.insert(mark.title);
    }
    return titles;
  };
  ExploreReport report = explored(small_options());
  std::set<std::string> expected;
  for (std::size_t i = 0; i < report.top.size(); ++i) {
    const ListedDesign& design = report.top[i];
    if (i >= 30 && design.name.empty()) continue;
    expected.insert((design.name.empty() ? "" : design.name + ": ") + design.ranked.design.word);
  }
  for (const std::string& title : lines(report)) {
    const std::string word = title.substr(title.rfind(' ') + 1);
    EXPECT_TRUE(std::any_of(expected.begin(), expected.end(),
                            [&](const std::string& one) { return one.ends_with(word); }) ||
                word == "M-1-T-2-F" || word == "F-1-P-2-F")
        << title;
  }
  EXPECT_GE(lines(report).size(), 30U);
  EXPECT_LE(lines(report).size(), 32U);
  EXPECT_EQ(lines(testing::large(20'000)).size(), 30U);
}

TEST(ParallelFigure, CountsEveryDesignOnEveryAxis) {
  const std::vector<PageDesign> all = designs(explored(small_options()));
  const std::vector<Objective> shown = shown_objectives({}, authors_score());
  const ReadPanel panel = read_chart(parallel_figure(all, shown).figure.svg).front();
  std::size_t counted = 0;
  for (const ReadMark& bar : panel.marks("paths", "how many designs")) {
    counted += std::stoul(bar.title);
  }
  EXPECT_EQ(counted, all.size() * shown.size());
}

// Colours and symbols mean the same wherever designs are drawn.
TEST(ParetoFigure, MarksWhatIsAdvised) {
  const ExploreReport report = explored(small_options());
  const std::vector<AdvisedDesign> advised = advised_designs(report);
  ASSERT_EQ(advised.size(), 2U);
  EXPECT_EQ(advised[0].word, "M-1b-B-2b-F");
  EXPECT_EQ(advised[0].label, "within 2 %");
  EXPECT_EQ(advised[1].label, "knee");
  const ReadPanel panel =
      read_chart(
          pareto_figure(designs(report), report.options.order.objectives, advised).figure.svg)
          .front();
  const std::vector<ReadMark> rings = panel.marks("points", "advised");
  ASSERT_EQ(rings.size(), 2U);
  EXPECT_EQ(rings[0].title.substr(0, rings[0].title.find('\n')), "M-1b-B-2b-F");
  EXPECT_NEAR(panel.x_of(rings[0]),
              value(report.tradeoff.affordable->ranked.design.values, Objective::uniformity_mean),
              1e-4);
}

TEST(ParallelFigure, SaysWhichAxesAreTurnedRound) {
  const ReadPanel panel = read_chart(parallel_figure(designs(explored(small_options())),
                                                     shown_objectives({}, authors_score()))
                                         .figure.svg)
                              .front();
  const auto& texts = panel.texts;
  EXPECT_EQ(std::count(texts.begin(), texts.end(), "sheaths (inverted)"), 1);
  EXPECT_EQ(std::count(texts.begin(), texts.end(), "uniformity mean"), 1);
}

TEST(ExplorationFigures, AreMadeEvenIfNothingIsLeft) {
  for (const std::string& svg :
       {pareto_figure({}, {Objective::uniformity_mean, Objective::efficiency_mean}).figure.svg,
        parallel_figure({}, shown_objectives({}, authors_score())).figure.svg}) {
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
  }
}

}  // namespace
}  // namespace reeve
