// From a ranking to a decision: tradeoff, prices, designs that are alike, constraints that nothing
// meets, by the command.
#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

const std::string prices = std::string(REEVE_CATALOG_DIR) + "/prices/example.toml";

bool says(const ProcessResult& result, const std::string& what) {
  return result.out.find(what) != std::string::npos;
}

TEST(Decision, OfFiveFingersNamesTheFirstAndTheOneThatSomebodyWouldBuild) {
  const Explored explored("--fingers 5");
  EXPECT_EQ(explored.result.exit_code, 0);
  EXPECT_TRUE(
      says(explored.result,
           "Best: 1b-P-2b-P-3b-P-1b+4-P-5-P-4: 10 sheaths, uniformity 0.996, efficiency 0.322 "
           "(2 equivalent variants)\n"));
  EXPECT_TRUE(says(explored.result,
                   "Fewest sheaths within 2 % of it: SoftHand (M-1b-B-2b-B-3b-B-4b-B-5b-M): 2 "
                   "sheaths, uniformity 0.985 (-1.0 %), efficiency 0.321 (-0.6 %)\n"));
  const Json tradeoff = explored.summary()["tradeoff"];
  EXPECT_EQ(tradeoff["steps"][0]["at_most"], 1);
  EXPECT_EQ(tradeoff["steps"][0]["routing"], "M-1b-B-2b-B-3b-B-4b-B-5b-F");
  EXPECT_NEAR(tradeoff["steps"][0]["kept"], 0.976, 5e-4);
  EXPECT_EQ(tradeoff["affordable"]["sheaths"], 2);
}

TEST(Decision, FollowsTheLossThatOneWouldBear) {
  const Explored strict("--fingers 5 --within 0.5%");
  EXPECT_EQ(strict.summary()["tradeoff"]["affordable"]["sheaths"], 5);
  const Explored loose("--fingers 5 --within 3%");
  EXPECT_EQ(loose.summary()["tradeoff"]["affordable"]["sheaths"], 1);
}

TEST(TradeoffFile, HasTheStepsOfTheSummary) {
  const Explored explored("--fingers 3 --tradeoff parts --top 1");
  const Json steps = explored.summary()["tradeoff"]["steps"];
  ASSERT_GT(steps.size(), 2U);
  std::vector<std::string> expected;
  for (const Json& step : steps) expected.push_back(step["routing"]);
  EXPECT_EQ(words(explored.file("tradeoff.csv")), expected);
  EXPECT_TRUE(
      explored.file("tradeoff.csv").starts_with("tradeoff,at_most,routing,name,rank,kept,"));
}

TEST(TradeoffFile, IsTheSameForAnyNumberOfThreads) {
  const Explored one({"--fingers", "4", "--threads", "1", "--cost", prices});
  const Explored three({"--fingers", "4", "--threads", "3", "--cost", prices});
  EXPECT_EQ(one.file("tradeoff.csv"), three.file("tradeoff.csv"));
  EXPECT_EQ(without_times(one.file("summary.json")), without_times(three.file("summary.json")));
}

// TR1: a sheath, three tubes, a fixed end, five segments of 100 mm.
TEST(Cost, IsAnObjectiveAConstraintAndATradeoff) {
  const ProcessResult rank = reeve({"rank", "TR1", "TR7", "--cost", prices, "--objectives",
                                    "uniformity,cost", "--format", "json"});
  ASSERT_EQ(rank.exit_code, 0) << rank.err;
  const Json ranked = Json::parse(rank.out);
  EXPECT_EQ(ranked["tradeoff"]["by"], "cost");
  for (const Json& design : ranked["designs"]) {
    EXPECT_EQ(design["front"], 1);
    if (design["name"] == "TR1") {
      EXPECT_NEAR(design["cost"], 14 + 3 * 0.8 + 0.5 + 0.002 * 500, 1e-9);
    }
  }
  const Explored explored({"--fingers", "3", "--cost", prices, "--constraint", "cost<=40"});
  const Json summary = explored.summary();
  ASSERT_FALSE(summary["top"].empty());
  for (const Json& design : summary["top"]) EXPECT_LE(design["cost"], 40);
  EXPECT_GT(summary["rejected"]["constraint cost<=40"], 0);
  EXPECT_TRUE(says(explored.result, " EUR, uniformity"));
}

TEST(Cost, IsMissingWhereThereAreNoPrices) {
  const Explored explored("--fingers 2");
  const Json summary = explored.summary();
  EXPECT_TRUE(summary["top"][0]["cost"].is_null());
  for (const Json& best : summary["best"]) EXPECT_NE(best["objective"], "cost");
  const std::string csv = explored.file("designs.csv");
  EXPECT_FALSE(has(csv, "inf"));
}

TEST(AlikeDesigns, AreOneLineInTheTableAndARowEachInTheFiles) {
  const Explored explored("--fingers 2");
  EXPECT_TRUE(says(explored.result, " equivalent to others\n"));
  EXPECT_FALSE(says(explored.result, "\n   2      1  "));
  EXPECT_TRUE(
      says(explored.result,
           "Equivalent variants of rank 1, with other bearings: 1-P-2b-P-1, 1b-P-2b-P-1b\n"));
  const Json top = explored.summary()["top"];
  EXPECT_EQ(top[0]["alike"].dump(), R"(["1-P-2b-P-1","1b-P-2b-P-1b"])");
  EXPECT_TRUE(top[0]["same_as"].is_null());
  EXPECT_EQ(top[1]["same_as"], "1-P-2-P-1");
  EXPECT_EQ(words(explored.file("designs.csv")).size(), top.size());
  std::set<std::string> firsts;
  std::istringstream csv(explored.file("designs.csv"));
  for (std::string line; std::getline(csv, line);) {
    line.resize(line.rfind(','));  // the exploration's id
    line.resize(line.rfind(','));  // the place
    firsts.insert(line.substr(line.rfind(',') + 1));
  }
  EXPECT_TRUE(firsts.contains("same_as") && firsts.contains("1-P-2-P-1") && firsts.contains(""));
}

TEST(Constraint, ThatNothingMeetsSaysTheLeastAndExitsWithOne) {
  const Explored explored("--fingers 2 --constraint sheaths<=0");
  EXPECT_EQ(explored.result.exit_code, 1);
  EXPECT_EQ(explored.result.err, "");
  EXPECT_TRUE(says(explored.result, "No design meets sheaths<=0: the least is 1\n"));
  EXPECT_EQ(explored.summary()["unmet"][0]["nearest"]["above"], 1);
  EXPECT_TRUE(has(explored.file("index.html"), "the least is 1."));
  EXPECT_EQ(reeve({"explore", "--constraint", "sheaths<=1", "--out", explored.out()}).exit_code, 0);
}

TEST(Constraint, ThatNothingMeetsLeavesKnownRoutingsWithoutRankAndThePlotWithoutAnEdge) {
  const Explored explored("--fingers 2 --constraint sheaths<=0");
  EXPECT_TRUE(says(explored.result, "reason\n"));
  EXPECT_TRUE(says(explored.result,
                   "TR7   1-P-2-P-1     -      -             -       0.998       0.322  fails "
                   "sheaths<=0\n"));
  EXPECT_FALSE(has(explored.file("index.html"), "dashed line"));
  EXPECT_TRUE(has(Explored("--fingers 2").file("index.html"), "dashed line"));
}

TEST(Constraints, AreColumnsOfTheTableThePageAndTheDraws) {
  const Explored explored({"--fingers", "3", "--hardware",
                           REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml", "--constraint",
                           "motor_force<=150", "--uncertainty", "--draws", "40", "--top", "5"});
  EXPECT_TRUE(says(explored.result, "  nominal motor (N)\n"));
  EXPECT_TRUE(says(explored.result, "  meets all  "));
  const Json first = explored.summary()["top"][0];
  const double met = first["constraints_met"];
  EXPECT_GT(met, 0);
  EXPECT_TRUE(has(explored.file("designs.csv"), ",constraints_met,exploration\n"));
  const std::string page = explored.file("index.html");
  EXPECT_TRUE(has(page, ">motor force, N</th>"));
  EXPECT_TRUE(has(page, "data-column=\"constraints_met\""));
  EXPECT_TRUE(has(page, "Constraints were judged at the nominal coefficients; in "));
}

TEST(Constraints, ThatNothingMeetsTogetherSayWhatGivesWay) {
  const Explored explored("--fingers 2 --constraint sheaths<=1 --constraint uniformity>=0.994");
  EXPECT_EQ(explored.result.exit_code, 1);
  EXPECT_TRUE(says(explored.result, "both by none\n"));
  EXPECT_TRUE(says(explored.result, "Of the designs that meet all but sheaths<=1, the least is 2"));
}

TEST(RankTradeoff, IsOfTheRoutingsThatAreGiven) {
  const ProcessResult result = reeve("rank --catalogue");
  EXPECT_TRUE(says(result, "Best design for each number of sheaths\n"));
  EXPECT_TRUE(says(result, "No design within 2 % of it has fewer sheaths\n"));
  EXPECT_FALSE(says(reeve("rank TR1"), "Best:"));
  const TemporaryFolder folder;
  reeve({"rank", "--catalogue", "--out", folder.path().string()});
  EXPECT_EQ(words(read_text(folder.path() / "tradeoff.csv")),
            (std::vector<std::string>{"M-1-T-2-F", "F-1-P-2-F", "1-P-2-P-1"}));
}

TEST(ExplorationPage, HasTheTradeoff) {
  const Explored explored("--fingers 2");
  const std::string page = explored.file("index.html");
  EXPECT_TRUE(has(page, "<section id=\"tradeoff\">"));
  EXPECT_TRUE(has(page, "Fewest sheaths within 2 % of it"));
}

}  // namespace
}  // namespace reeve::testing
