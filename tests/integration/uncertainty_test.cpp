// Objectives under uncertainty from end to end: the same numbers in every file, and those by which
// `size` judges.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

Json bands_by_word(const Json& designs) {
  Json bands = Json::object();
  for (const Json& design : designs) bands[design["routing"].get<std::string>()] = design["bands"];
  return bands;
}

// `size` makes the 5 % quantile of its goal the thing to be great.
TEST(Bands, HaveTheQuantileByWhichSizingIsRobust) {
  const Arguments ranking("rank TR1 --uncertainty --draws 1000 --seed 3 --format json");
  // The search uses a few draws, and the result uses 1000.
  const Arguments sizing(
      "size TR1 --goal efficiency_mean --vary tip_angle=1..4 --draws 40 --seed 3 --format json");
  const Json band = Json::parse(reeve(ranking).out)["designs"][0]["bands"]["efficiency_mean"];
  const Json sized = Json::parse(reeve(sizing).out)["designs"][0];
  EXPECT_NEAR(sized["before"]["goal"].get<double>(), band["p5"].get<double>(), 1e-9);
}

TEST(Bands, AreTheSameInCsvAndJson) {
  const Arguments rank("rank --catalogue --uncertainty --draws 30 --format");
  Arguments as_json = rank;
  Arguments as_csv = rank;
  as_json.push_back("json");
  as_csv.push_back("csv");
  const Json json = Json::parse(reeve(as_json).out);
  const auto rows = rows_of(reeve(as_csv).out);
  ASSERT_EQ(rows.size(), 7U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Json& design = json["designs"][i];
    EXPECT_EQ(rows[i].at("routing"), design["routing"]);
    EXPECT_EQ(std::stoul(rows[i].at("place")), design["place"].get<std::size_t>());
    for (const auto& [objective, band] : design["bands"].items()) {
      for (const char* part : {"median", "p5", "p95"}) {
        EXPECT_EQ(std::stod(rows[i].at(objective + "_" + part)), band[part].get<double>());
      }
    }
  }
  // TR3 and TR6 are equal.
  EXPECT_EQ(rows[1].at("place"), "2");
  EXPECT_EQ(rows[2].at("place"), "2");
  EXPECT_EQ(rows[2].at("rank"), "3");
}

TEST(Bands, AreThereForKnownRoutingsBeyondTheList) {
  const Json all = bands_by_word(Explored("--uncertainty --draws 9").summary()["top"]);
  const Json few = Explored("--uncertainty --draws 9 --top 1").summary();
  ASSERT_EQ(few["known"].size(), 7U);
  for (const Json& known : few["known"]) {
    EXPECT_EQ(known["bands"], all[known["routing"].get<std::string>()]) << known["name"];
  }
}

TEST(SharedPlaces, AreSaidInWordsAndInTheTable) {
  // Contacts that are not alike would tell the two apart.
  const TemporaryFolder folder;
  const std::filesystem::path alike = folder.write(
      "alike.toml", "[uncertainty]\ncontact_relative = 0\nbearing_contact_relative = 0\n");
  const std::string text = reeve({"rank", "TR7", "1-P-2b-P-1", "TR1", "--uncertainty", "--draws",
                                  "9", "--hardware", alike.string()})
                               .out;
  EXPECT_TRUE(
      has(text,
          "Equal in all ranked objectives: TR7 and 1-P-2b-P-1; they share the first place in "
          "100.0 % of the draws"));
  EXPECT_TRUE(has(text, "100.0 %, shared"));
}

TEST(Sweep, IsTheSameInCsvAndJsonAndOnThePage) {
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  const ProcessResult result =
      reeve({"rank", "--catalogue", "--grasps", "paper", "--score", "authors", "--uncertainty",
             "--draws", "20", "--sweep", "mu=0.02..0.3", "--out", out});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json sweep = Json::parse(read_text(folder.path() / "ranking.json"))["sweep"];
  const auto rows = rows_of(read_text(folder.path() / "sweep.csv"));
  ASSERT_EQ(rows.size(), 7U * 29);
  for (std::size_t i = 0; i < 7; ++i) {
    const Json& design = sweep["designs"][i];
    for (std::size_t k = 0; k < 29; ++k) {
      const auto& row = rows[29 * i + k];
      EXPECT_EQ(row.at("routing"), design["routing"]);
      EXPECT_EQ(std::stod(row.at("at")), sweep["at"][k].get<double>());
      EXPECT_EQ(std::stoul(row.at("place")), design["place"][k].get<std::size_t>());
      const Json& curve = design["objectives"]["score"];
      EXPECT_EQ(std::stod(row.at("score")), curve["nominal"][k].get<double>());
      EXPECT_EQ(std::stod(row.at("score_p5")), curve["p5"][k].get<double>());
      EXPECT_EQ(std::stod(row.at("score_p95")), curve["p95"][k].get<double>());
    }
  }
  // docs/tr7.md: TR7 by the authors' own measure is first with much friction only.
  EXPECT_EQ(sweep["leads"].size(), 3U);
  EXPECT_EQ(sweep["leads"][1]["first"].dump(), R"(["F-1-P-2-F","1-T-2-P-1"])");
  EXPECT_TRUE(has(result.out, "\nTR3 and TR6, which are equal, come first from 0.0"));
  const std::string html = read_text(folder.path() / "index.html");
  EXPECT_TRUE(has(html, "<p>TR3 and TR6, which are equal, come first from 0.0"));
  EXPECT_TRUE(has(html, "id=\"sweep-score\""));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "figures" / "sweep-score.svg"));
}

TEST(Sweep, OfAnExplorationIsOfTheFirstTheTradeoffAndTheFront) {
  const Explored explored("--sweep tube_mu=0.05..0.2");
  const Json summary = explored.summary();
  std::vector<std::string> words;
  for (const Json& design : summary["sweep"]["designs"]) words.push_back(design["routing"]);
  EXPECT_EQ(words[0], summary["top"][0]["routing"]);
  EXPECT_LE(words.size(), 8U);
  for (const Json& step : summary["tradeoff"]["steps"]) {
    EXPECT_NE(std::find(words.begin(), words.end(), step["routing"]), words.end());
  }
  EXPECT_TRUE(has(explored.file("sweep.csv"), "\ntube_mu,0.2,"));
  EXPECT_FALSE(summary["partial"]);
}

TEST(Sweep, OfNothingIsEmpty) {
  const Explored explored("--constraint sheaths<=0 --sweep mu=0..0.3");
  EXPECT_EQ(explored.result.exit_code, 1);
  EXPECT_TRUE(explored.summary()["sweep"]["designs"].empty());
}

}  // namespace
}  // namespace reeve::testing
