#include "pages/exploration/exploration_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <string>

#include "pages/exploration/exploration_answer.hpp"
#include "pages/exploration/exploration_designs.hpp"
#include "search/evaluate/shown_objectives.hpp"
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

double& value_of(ListedDesign& design, Objective objective) {
  return design.ranked.design.values[static_cast<std::size_t>(objective)];
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

TEST(ExplorationPage, HasDetailsOfTheBestTheTradeoffAndTheKnownAndSaysSo) {
  const ExploreReport report = explored(small_options());
  ExplorationView view = testing::view(report);
  view.details = 5;
  const std::string html = exploration_page(view).html;
  std::set<std::string> expected{"M-1-T-2-F", "F-1-P-2-F", "1-P-2-P-1"};
  for (std::size_t i = 0; i < 5; ++i) expected.insert(report.top[i].ranked.design.word);
  for (const ListedDesign* named : named_designs(report)) {
    expected.insert(named->ranked.design.word);
  }
  EXPECT_EQ(expected.size(), 8U);
  EXPECT_EQ(detailed_words(html), expected);
  EXPECT_NE(html.find("8 of 54 listed designs and known routings have schematics"),
            std::string::npos);
  EXPECT_NE(html.find("with --details 54 it has all"), std::string::npos);
}

// Words of what is drawn in the first grasp alone stand in chunks of their own, behind the others.
TEST(ExplorationPage, DrawsFurtherDesignsInTheFirstGraspUnlessItIsSaidHowMany) {
  const ExploreReport report = explored(small_options(3));
  ExplorationView view = testing::view(report);
  const std::size_t whole = usual_schematics / 4;
  const std::string html = exploration_page(view).html;
  EXPECT_GT(detailed_words(html).size(), whole + 100);
  EXPECT_NE(html.find("more their schematic in the first grasp"), std::string::npos);
  view.details = whole;
  const std::string asked = exploration_page(view).html;
  EXPECT_LT(detailed_words(asked).size(), whole + 20);
  EXPECT_EQ(asked.find("more their schematic in the first grasp"), std::string::npos);
}

TEST(ExplorationPage, BeginsWithTheFirstAndTheAffordableDesignBesideEachOther) {
  const ExploreReport report = explored(small_options());
  const std::string html = exploration_page(testing::view(report)).html;
  const std::size_t answer = html.find("Best: 1-P-2-P-1: 4 sheaths");
  const std::size_t first = html.find("id=\"slot-first-title\"");
  const std::size_t affordable = html.find("id=\"slot-affordable-title\"");
  const std::size_t tradeoff = html.find("<section id=\"tradeoff\">");
  ASSERT_NE(affordable, std::string::npos);
  EXPECT_LT(answer, first);
  EXPECT_LT(first, affordable);
  EXPECT_LT(affordable, tradeoff);
  EXPECT_LT(tradeoff, html.find("id=\"plots\""));
  EXPECT_NE(html.find("<h2>Fewest sheaths within 2 %</h2>\n<p class=\"word\">M-1b-B-2b-F</p>"),
            std::string::npos);
  const Json tradeoff_data = page_data(html)["tradeoff"];
  EXPECT_EQ(tradeoff_data["affordable"], "M-1b-B-2b-F");
  EXPECT_EQ(tradeoff_data["knee"], "F-1b-P-2b-F");
}

TEST(ExplorationPage, HasALineForDesignsThatAreAlike) {
  const ExploreReport report = explored(small_options());
  const std::string html = exploration_page(testing::view(report)).html;
  EXPECT_NE(html.find("<th scope=\"row\" class=\"left\">1-P-2-P-1</th><td>+2</td>"),
            std::string::npos);
  EXPECT_EQ(html.find("<th scope=\"row\" class=\"left\">1-P-2b-P-1</th>"), std::string::npos);
}

// As in the terminal.
TEST(ExplorationPage, WritesADashOfWhatThereIsNoneOf) {
  ExploreReport report = explored(small_options());
  for (ListedDesign& design : report.top) {
    value_of(design, Objective::travel) = std::numeric_limits<double>::infinity();
  }
  const std::string html = exploration_page(testing::view(report)).html;
  EXPECT_NE(html.find("<td>-</td>"), std::string::npos);
  EXPECT_EQ(html.find("<td>inf"), std::string::npos);
  EXPECT_EQ(html.find("travel inf"), std::string::npos);
}

// Schematics that no compression makes small.
TEST(ExplorationPage, AsksForNoMoreDetailsThanItHasRoomFor) {
  const ExploreReport report = explored(small_options());
  ExplorationView view = testing::view(report);
  view.details = 54;
  view.solve = [&report](const Routing& routing) {
    SolvedRouting shown = testing::view(report).solve(routing);
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

TEST(ExplorationPage, WritesItsFiguresAsFiles) {
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
    SolvedRouting shown = testing::view(report).solve(routing);
    shown.name = hostile;
    return shown;
  };
  const PageFiles page = exploration_page(view);
  EXPECT_EQ(page.html.find("<script>alert"), std::string::npos);
  EXPECT_NE(page.html.find("&lt;script&gt;alert"), std::string::npos);
  EXPECT_EQ(page_data(page.html)["commands"]["options"], view.show_options);
}

// The assumptions stand beside the answer, before anything is folded.
TEST(ExplorationPage, SaysOnTheFirstScreenWhatWasAssumed) {
  const std::string html = exploration_page(testing::view(explored(small_options()))).html;
  const std::string screen = html.substr(0, html.find("class=\"workspace\""));
  for (const char* said :
       {"id=\"assumed\">Assumed, by default: tubes mu 0.18 over 180 deg, ",
        "; only capstan friction. Parts: tips tube, bearing; joins T, B, P; ends M, F; any number ",
        ". Fingers held: none/1/2.</p>"}) {
    EXPECT_NE(screen.find(said), std::string::npos) << said;
  }
}

TEST(ExplorationPage, SaysThatItIsPartial) {
  ExploreReport report = explored(small_options());
  report.result.partial = true;
  report.result.total = 1000;
  const PageFiles page = exploration_page(testing::view(report));
  EXPECT_NE(page.html.find("This exploration is partial: stopped after 126 of 1000 routings"),
            std::string::npos);
}

// Who stops it waits for its end.
TEST(ExplorationPage, HasFewDetailsWhereItIsPartial) {
  ExploreReport report = explored(small_options());
  const auto details = [&report] {
    std::size_t designs = 0;
    const Json data = page_data(exploration_page(testing::view(report)).html);
    for (const Json& chunk : data["chunks"]) designs += chunk["words"].size();
    return designs;
  };
  const std::size_t whole = details();
  report.result.partial = true;
  EXPECT_GT(whole, 2 * details());
}

TEST(ExplorationPage, IsMadeEvenIfNothingIsLeft) {
  ExploreOptions options = small_options();
  options.constraints.push_back(parse_constraint("sheaths<=0"));
  const PageFiles page = exploration_page(testing::view(explored(options)));
  EXPECT_NE(page.html.find("No design is left to rank"), std::string::npos);
  EXPECT_EQ(page.html.find("id=\"bests\""), std::string::npos);
  for (const char* empty : {"Why it comes first", "When another design comes first"}) {
    EXPECT_EQ(page.html.find(empty), std::string::npos) << empty;
  }
  options.references.clear();
  const std::string without_known = exploration_page(testing::view(explored(options))).html;
  for (const char* place : {"<div class=\"workspace\" hidden>", "id=\"comparison\" hidden>"}) {
    EXPECT_EQ(page.html.find(place), std::string::npos) << place;
    EXPECT_NE(without_known.find(place), std::string::npos) << place;
  }
}

TEST(ExplorationPage, StaysBelowFiveMegabytesWithAHundredThousandDesigns) {
  const ExploreReport report = testing::large(100'000);
  const SolvedRouting shown = solved_routing(parse_routing("1b-P-2b-P-3b-P-1b+4-P-5-P-4"), {},
                                             single_grasps(5), Direction::pull, Catalogue{});
  std::size_t solved = 0;
  const SolveDesign solve = [&](const Routing& routing) {
    SolvedRouting own = shown;
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
  EXPECT_EQ(designs[0].kind, DesignKind::known);
  EXPECT_EQ(designs[1].kind, DesignKind::front);
  EXPECT_EQ(designs[53].kind, DesignKind::sample);
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

TEST(PageDesigns, HaveTheirDrawsInColumns) {
  PageDesign design;
  design.distribution = RankDistribution{0.125, 2, 3, 4};
  const Json drawn = design_columns({design}, {})["distribution"];
  for (const auto& [name, value] :
       {std::pair{"first", 0.125}, {"median", 2}, {"low", 3}, {"high", 4}}) {
    EXPECT_EQ(drawn[name], Json({value})) << name;
  }
}

TEST(PageObjectives, SayWhichWayIsBetterAndCountBlocksAndCostWhereThereAreAny) {
  const Json json = objectives_json({Objective::uniformity_mean, Objective::travel});
  EXPECT_EQ(json[0]["better"], "higher");
  EXPECT_EQ(json[1]["better"], "lower");
  ExploreReport report;
  report.options = small_options();
  const auto has = [&](Objective objective) {
    const std::vector<Objective> shown = page_objectives(report);
    return std::count(shown.begin(), shown.end(), objective) == 1;
  };
  EXPECT_FALSE(has(Objective::blocks) || has(Objective::cost));
  report.options.generator.parts.blocks = 1;
  report.options.prices.emplace();
  EXPECT_TRUE(has(Objective::blocks) && has(Objective::cost));
}

// Fifty designs at least, and the whole front of up to two hundred.
TEST(StaticTables, HaveTheFrontAndTheFirstDesigns) {
  for (const auto& [designs, rows] : {std::pair{1'000U, 50U}, {10'000U, 100U}, {30'000U, 200U}}) {
    EXPECT_EQ(pages::static_tables(testing::large(designs))["rows"].size(), rows) << designs;
  }
}

TEST(StaticTables, WriteSharesWithFourDecimalsAndCostsAsTheyAre) {
  ExploreReport report = testing::large(100);
  report.options.prices.emplace();
  value_of(report.top[0], Objective::cost) = 0.5;
  value_of(report.top[0], Objective::uniformity_mean) = 0.5;
  report.top[0].distribution->first = 0.25;
  const Json row = pages::static_tables(report)["rows"][0]["cells"];
  const std::size_t objectives = page_objectives(report).size();
  EXPECT_EQ(row[0], "0.5000");
  EXPECT_EQ(row[objectives - 1], "0.5");
  EXPECT_EQ(row[objectives], "25.0 %");
}

TEST(StaticTables, HaveTheBestByEachObjectiveBesideTheFirst) {
  const Json bests = pages::static_tables(explored(small_options()))["bests"];
  const auto best = std::find_if(bests.begin(), bests.end(), [](const Json& json) {
    return json["title"] == "force transmission";
  });
  ASSERT_NE(best, bests.end());
  EXPECT_EQ((*best)["design"], "M-1b-B-2b-F");
  // Four strands of e^{-0.36π} with a bearing between each two; those of TR7 have a quarter each.
  EXPECT_EQ((*best)["value"], "1.2848");
  EXPECT_EQ((*best)["first"], "0.3227");
}

TEST(PageDesigns, NameTheDesignThatStandsForThem) {
  const ExploreReport report = explored(small_options());
  const std::vector<PageDesign> designs = page_designs(report, 1'000'000);
  const Json same_as = design_columns(designs, {})["same_as"];
  std::size_t equivalent = 0;
  for (std::size_t i = 0; i < report.top.size(); ++i) {
    const std::string& of = report.top[i].same_as;
    if (of.empty()) {
      EXPECT_EQ(same_as[i], -1) << designs[i].word;
      continue;
    }
    ++equivalent;
    EXPECT_EQ(designs[same_as[i].get<std::size_t>()].word, of);
  }
  EXPECT_GT(equivalent, 5U);
}

// A step may lie beyond the list, and the page draws it all the same.
TEST(PageDesigns, HoldTheTradeoff) {
  ExploreOptions options = small_options();
  options.top = 1;
  options.references.clear();
  ExploreReport report = explored(options);
  report.result.sample.clear();
  std::set<std::string> expected;
  for (const ListedDesign& design : listed_designs(report)) {
    expected.insert(design.ranked.design.word);
  }
  for (const ListedDesign& step : report.tradeoff.steps) expected.insert(step.ranked.design.word);
  std::set<std::string> words;
  for (const PageDesign& design : page_designs(report, 1'000'000)) words.insert(design.word);
  EXPECT_EQ(words, expected);
  EXPECT_TRUE(words.contains("M-1b-B-2b-F"));
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
