// The page of `rank --out`: its answer, charts and drawings; escaping; the files beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "tests/pages/ranked.hpp"
#include "tests/support/svg.hpp"

namespace reeve::testing {
namespace {

// Rounded as the ranking is, to three decimals, where designs share a spot.
TEST(RankingPlot, PutsEachDesignWhereItsValuesAre) {
  const ReadPanel panel = catalogue().chart("pareto").front();
  std::size_t designs = 0;
  const auto marks = panel.marks("points");
  for (const Json& design : catalogue().json["designs"]) {
    const std::string name = design["name"];
    const auto drawn = std::find_if(marks.begin(), marks.end(), [&](const ReadMark& mark) {
      return mark.title.substr(0, mark.title.find('\n')).find(name) != std::string::npos;
    });
    ASSERT_NE(drawn, marks.end()) << name;
    EXPECT_NEAR(panel.x_of(*drawn), design["uniformity"]["mean"], 6e-4) << name;
    EXPECT_NEAR(panel.y_of(*drawn), design["efficiency"]["mean"], 6e-4) << name;
    ++designs;
  }
  EXPECT_EQ(designs, 7U);
  EXPECT_EQ(panel.marks("points", "on the Pareto front").size(), 1U);
  EXPECT_EQ(marks.size(), 6U);  // TR3 and TR6 share one
  for (const char* label : {"TR7", "TR3, TR6", "TR1", "TR2", "TR4", "TR5"}) {
    EXPECT_EQ(std::count(panel.texts.begin(), panel.texts.end(), label), 1) << label;
  }
}

TEST(RankingPlot, TellsCostsOfGramsInTonnesApart) {
  const TemporaryFolder folder;
  folder.write("tonnes.toml", "unit = \"t\"\nsheath = 2.1e-6\n");
  const Ranked ranked({"TR1", "TR3", "TR7", "--objectives", "cost,jams", "--cost",
                       (folder.path() / "tonnes.toml").string()});
  EXPECT_EQ(ranked.chart("pareto").front().marks("points").size(), 3U);
  EXPECT_NE(ranked.html.find(">0.0000042<"), std::string::npos);
}

TEST(RankingPage, SaysOnTheFirstScreenWhatWasAssumed) {
  EXPECT_NE(
      catalogue().html.find("id=\"assumed\">Assumed, by default: tubes mu 0.18 over 180 deg, "),
      std::string::npos);
}

TEST(RankingCharts, DrawTheTensionsOfTheFileAsBars) {
  const std::vector<ReadPanel> panels = catalogue().chart("tensions-held-1");
  const Json& routings = catalogue().json["routings"];
  ASSERT_EQ(panels.size(), routings.size());
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Json& tensions = routings[i]["grasps"][1]["tensions"];
    EXPECT_EQ(panels[i].marks("bars").size(), 4U);
    for (const ReadMark& bar : panels[i].marks("bars")) {
      EXPECT_NEAR(panels[i].y_of(bar), tensions[panels[i].category_of(bar)], 1e-4);
    }
  }
}

TEST(RankingPage, LiesBesideTheUsualResult) {
  EXPECT_TRUE(catalogue().result.out.starts_with(reeve({"rank", "--catalogue"}).out));
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  const ProcessResult printed = reeve({"rank", "--catalogue", "--format", "json", "--out", out});
  EXPECT_EQ(read_text(folder.path() / "ranking.json"), printed.out);
}

TEST(RankingPage, NamesTheBestDesignAndThoseBestByOneObjective) {
  const std::string& html = catalogue().html;
  EXPECT_NE(html.find("TR7 comes first, with mean uniformity 0.998"), std::string::npos);
  EXPECT_NE(html.find("<li>force transmission ("), std::string::npos);
  for (const Json& best : catalogue().json["best"]) {
    if (best["objective"] == "force_transmission") {
      EXPECT_EQ(best["routings"].dump(), R"(["M-1-T-2-F"])");
    }
  }
}

TEST(RankingPage, DrawsEachRoutingInEachGrasp) {
  EXPECT_EQ(count(catalogue().html, "<figure class=\"schematic\""), 7U * 3);
  EXPECT_EQ(catalogue().json["routings"].size(), 7U);
  for (const char* file :
       {"pareto", "figure-9", "tensions-held-none", "TR7-held-1", "TR1-held-2"}) {
    const std::filesystem::path figures = catalogue().folder.path() / "page" / "figures";
    EXPECT_TRUE(std::filesystem::exists(figures / (std::string(file) + ".svg"))) << file;
  }
}

TEST(RankingPage, SaysWhatUncertaintyAndMarginsFind) {
  const Ranked ranked({"TR1", "TR3", "TR7", "--uncertainty", "--draws", "20", "--margin"});
  // TR1 has a third of TR7's uniformity, TR3 half of it.
  EXPECT_NE(ranked.html.find("it is least over TR3, "), std::string::npos);
  for (const char* part : {"id=\"ranks\"", "id=\"margins-table\"", "id=\"ranges-table\"",
                           "first in 100.0 % of the draws", "20 draws, seed 1"}) {
    EXPECT_NE(ranked.html.find(part), std::string::npos) << part;
  }
}

TEST(RankingPage, HasTheSameBytesEachTime) {
  const TemporaryFolder folder;
  ProcessOptions options;
  options.directory = folder.path();
  reeve({"rank", "TR1", "TR7", "--out", "a"}, options);
  const std::string first = read_text(folder.path() / "a" / "index.html");
  reeve({"rank", "TR1", "TR7", "--out", "a", "--threads", "1"}, options);
  EXPECT_TRUE(read_text(folder.path() / "a" / "index.html") == first);
}

// Names of routings are plain; those of files, of runs and of columns are anything.
TEST(RankingPage, EscapesWhatUsersWrite) {
  const TemporaryFolder folder;
  const std::string data = folder
                               .write("<b>&.csv",
                                      "run,routing,held,</script><img>,T1_N,T2_N,T3_N,T4_N\n"
                                      "A,TR1,1,5,4,3,2,1\n")
                               .string();
  const Ranked ranked({"TR1", "TR3", "--data", data});
  const std::string page = ranked.html.substr(0, ranked.html.find("</main>"));
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;&amp;.csv"), std::string::npos);
  EXPECT_NE(page.find("&lt;/script&gt;&lt;img&gt;"), std::string::npos);
}

TEST(RankingPage, SaysWhatDecidesWithinAFrontAndWhatMayBeAskedFor) {
  EXPECT_NE(catalogue().html.find("<code>--uncertainty</code> and <code>--margin</code> do."),
            std::string::npos);
  const Ranked plain({"--catalogue", "--objectives", "uniformity,sheaths"});
  // With four sheaths, two and one; TR2 is less uniform than TR3.
  EXPECT_NE(plain.html.find("4 routings are on the Pareto front, none of which is better than "
                            "another in all objectives chosen: TR7, TR3, TR6, TR1. Among them the "
                            "product of both means decides."),
            std::string::npos);
  EXPECT_NE(plain.html.find("<code>--uncertainty</code> does."), std::string::npos);
  const Ranked scored(
      {"--catalogue", "--objectives", "uniformity,sheaths", "--score", "uniformity=1"});
  const std::string answer = scored.html.substr(scored.html.find("id=\"answer\""), 2000);
  EXPECT_NE(answer.find("comes first, with score "), std::string::npos) << answer;
  EXPECT_NE(answer.find("within a front by the score, the weighted mean of uniformity_mean=1"),
            std::string::npos);
  EXPECT_NE(answer.find("Among them the score decides."), std::string::npos);
}

// As the page of an exploration has it, from the same trade-off as the terminal's.
TEST(RankingPage, HasTheTradeoff) {
  const Ranked ranked({"TR3", "TR7", "M-1b-B-2b-M", "M-1b-B-2b-F"});
  EXPECT_NE(ranked.html.find("<section id=\"tradeoff\">"), std::string::npos);
  EXPECT_NE(ranked.html.find("<p class=\"decision\">Fewest sheaths within 2 % of it: "
                             "M-1b-B-2b-F: 1 sheath"),
            std::string::npos);
  for (const Json& step : ranked.json["tradeoff"]["steps"]) {
    EXPECT_NE(ranked.html.find("<td class=\"left short\">" + step["routing"].get<std::string>() +
                               "</td>"),
              std::string::npos);
  }
  EXPECT_GE(ranked.json["tradeoff"]["steps"].size(), 2U);
  EXPECT_EQ(Ranked({"TR1"}).html.find("id=\"tradeoff\""), std::string::npos);
}

// Orange squares are the front on every page.
TEST(RankingPage, DrawsTheFrontAsTheExplorationDoes) {
  const ReadPanel panel = catalogue().chart("pareto").front();
  for (const ReadGroup& group : panel.groups) {
    if (group.series == "on the Pareto front") {
      EXPECT_NE(group.attributes.find("reeve-orange"), std::string::npos) << group.attributes;
    }
    if (group.series == "dominated") {
      EXPECT_NE(group.attributes.find("reeve-blue"), std::string::npos) << group.attributes;
    }
  }
}

}  // namespace
}  // namespace reeve::testing
