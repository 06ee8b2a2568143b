#include "pages/exploration/exploration_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <set>
#include <string>

#include "pages/exploration/exploration_designs.hpp"
#include "search/judge/shown_objectives.hpp"
#include "tests/pages/explored.hpp"

namespace reeve {
namespace {

using testing::explored;
using testing::small_options;

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
  ExplorationView view = testing::view(report);
  view.details = 1000;
  const PageFiles page = exploration_page(view);
  EXPECT_EQ(detailed_words(page.html).size(), 54U);
  EXPECT_NE(page.html.find("54 of 54 ranked designs are listed"), std::string::npos);
  EXPECT_LT(page.html.size(), 1'300'000U);
}

TEST(ExplorationPage, HasDetailsOfTheBestAndTheKnownAndSaysSo) {
  const ExploreReport report = explored(small_options());
  ExplorationView view = testing::view(report);
  view.details = 5;
  const std::string html = exploration_page(view).html;
  std::set<std::string> expected{"M-1-T-2-F", "F-1-P-2-F", "1-P-2-P-1"};
  for (std::size_t i = 0; i < 5; ++i) expected.insert(report.top[i].ranked.design.word);
  EXPECT_EQ(detailed_words(html), expected);
  EXPECT_NE(html.find("7 of 54 listed designs and known routings have schematics"),
            std::string::npos);
  EXPECT_NE(html.find("with --details 54 it has all"), std::string::npos);
}

// Schematics that no compression makes small.
TEST(ExplorationPage, AsksForNoMoreDetailsThanItHasRoomFor) {
  const ExploreReport report = explored(small_options());
  ExplorationView view = testing::view(report);
  view.details = 54;
  view.solve = [&report](const Routing& routing) {
    ShownRouting shown = testing::view(report).solve(routing);
    std::mt19937 letters(static_cast<unsigned>(std::hash<std::string>()(to_word(routing))));
    for (int i = 0; i < 100'000; ++i) shown.name += static_cast<char>('a' + letters() % 26);
    return shown;
  };
  const std::string html = exploration_page(view).html;
  EXPECT_LT(html.size(), page_bytes);
  EXPECT_NE(html.find("of 54 listed designs and known routings have schematics"),
            std::string::npos);
  EXPECT_NE(html.find("there is no room for more of them, whatever --details says."),
            std::string::npos);
  EXPECT_EQ(html.find("with --details 54"), std::string::npos);
}

TEST(ExplorationPage, WritesItsPicturesAsFiles) {
  const PageFiles page = exploration_page(testing::view(explored(small_options())));
  std::set<std::string> ids;
  for (const FigureFile& file : page.figures) {
    EXPECT_TRUE(file.svg.starts_with("<svg ")) << file.id;
    EXPECT_TRUE(ids.insert(file.id).second) << file.id;
  }
  for (const char* id : {"pareto", "parallel", "1-P-2-P-1-held-none", "M-1-T-2-F-held-none"}) {
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
  view.solve = [&report, hostile](const Routing& routing) {
    ShownRouting shown = testing::view(report).solve(routing);
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
  const ShownRouting shown = shown_routing(parse_routing("1b-P-2b-P-3b-P-1b+4-P-5-P-4"), {},
                                           single_grasps(5), Direction::pull, Catalogue{});
  std::size_t solved = 0;
  const SolveDesign solve = [&](const Routing& routing) {
    ShownRouting own = shown;
    own.word = to_word(routing);
    // Noise, so that designs are as unlike as real ones are, and more.
    for (ShownGrasp& grasp : own.grasps) {
      for (double& tension : grasp.state.tension) {
        tension *= static_cast<double>(1 + ++solved % 997) / 500;
      }
    }
    return own;
  };
  const PageFiles page = exploration_page({report, "reeve explore", "", solve, 100'000});
  EXPECT_LT(page.html.size(), 5'000'000U);
  EXPECT_GT(page.html.size(), 3'000'000U);  // it does not give up room that it has
  EXPECT_GT(detailed_words(page.html).size(), 100U);
  EXPECT_LT(detailed_words(page.html).size(), 100'000U);
  EXPECT_NE(page.html.find("For the others the page gives the values"), std::string::npos);
  EXPECT_NE(page.html.find("; this page holds the first "), std::string::npos);
  for (const FigureFile& file : page.figures) EXPECT_LT(file.svg.size(), 1'500'000U) << file.id;
}

TEST(PageDesigns, AreHeldOnceEach) {
  ExploreOptions options = small_options();
  options.top = 5;
  const std::vector<PageDesign> designs = page_designs(explored(options), 5);
  std::set<std::string> words;
  for (const PageDesign& design : designs) {
    EXPECT_TRUE(words.insert(design.word).second) << design.word;
  }
  EXPECT_EQ(words.size(), 54U);  // the sample is all that there is
  EXPECT_EQ(designs[0].kind, Kind::known);
  EXPECT_EQ(designs[1].kind, Kind::front);
  EXPECT_EQ(designs[53].kind, Kind::sample);
}

TEST(PageDesigns, StandInColumnsOfOneLength) {
  const std::vector<PageDesign> designs = page_designs(explored(small_options()), 1'000'000);
  const std::vector<Objective> shown = shown_objectives({}, authors_score());
  const Json columns = design_columns(designs, shown);
  EXPECT_EQ(columns["values"].size(), shown.size());
  for (const Json& column : columns["values"]) EXPECT_EQ(column.size(), designs.size());
  for (std::size_t i = 0; i < designs.size(); ++i) {
    EXPECT_EQ(columns["word"][i], designs[i].word);
    EXPECT_EQ(columns["kind"][i], static_cast<int>(designs[i].kind));
    EXPECT_NEAR(columns["values"][2][i], designs[i].values[2], 1e-8);
  }
}

// The page's script fills in what a specification leaves out, so no data may stand in one.
TEST(ExplorationPage, HasSpecificationsWithoutData) {
  const PageFiles page = exploration_page(testing::view(explored(small_options())));
  const Json specifications = page_data(page.html)["specifications"];
  for (const char* name : {"pareto", "parallel", "tensions", "ranks"}) {
    ASSERT_TRUE(specifications[name]["datasets"].is_object()) << name;
    for (const auto& [set, values] : specifications[name]["datasets"].items()) {
      EXPECT_TRUE(values.empty()) << name << ": " << set;
    }
    EXPECT_EQ(specifications[name].dump().find("\"values\":[{"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace reeve
