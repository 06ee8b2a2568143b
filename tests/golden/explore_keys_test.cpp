// The keys of what an exploration writes where no file in expected/ has them: target, sweep, shard,
// trade-off, unmet constraints.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/golden/json_keys.hpp"

namespace reeve::testing {
namespace {

TEST(KeysOfATarget, AreThePromisedOnes) {
  EXPECT_TRUE(summary()["target"].is_null());
  const Json json = summary({"--target", "1=1.1,2=1", "--parts", "paper"});
  EXPECT_EQ(keys(json["target"]), "target_shares grasps partial by_statics designs");
  EXPECT_EQ(keys(json["target"]["designs"][0]),
            "routing name met by_statics hangs_on_friction miss_without_friction miss_before miss "
            "shares shares_at_half_friction shares_at_one_and_a_half_friction "
            "miss_with_unlike_contacts shares_with_unlike_contacts motor hardware");
  EXPECT_EQ(json["settings"]["target_shares"], json["target"]["target_shares"]);
}

TEST(KeysOfASweep, AreThePromisedOnes) {
  const Json json = json_of({"rank", "TR1", "TR7", "--sweep", "mu=0.1..0.2"})["sweep"];
  EXPECT_EQ(keys(json), "coefficient unit at leads designs");
  EXPECT_EQ(keys(json["leads"][0]), "from to first");
  EXPECT_EQ(keys(json["designs"][0]), "routing name place objectives");
  EXPECT_EQ(keys(json["designs"][0]["objectives"]), "uniformity_mean efficiency_mean");
  const Json& curve = json["designs"][0]["objectives"]["efficiency_mean"];
  EXPECT_EQ(keys(curve), "nominal median p5 p95");
  EXPECT_EQ(curve["nominal"].size(), json["at"].size());
  EXPECT_TRUE(curve["median"].is_null());
  const Json explored =
      summary({"--sweep", "mu=0.1..0.2", "--uncertainty", "--draws", "3", "--top", "1"});
  EXPECT_EQ(keys(explored["sweep"]), keys(json));
  EXPECT_EQ(explored["settings"]["sweep"].dump(), R"({"coefficient":"mu","from":0.1,"to":0.2})");
  EXPECT_EQ(explored["sweep"]["designs"][0]["objectives"]["efficiency_mean"]["p5"].size(),
            json["at"].size());
  EXPECT_EQ(keys(explored["known"][0]),
            "name routing rank front dominated_by generated "
            "rejected_by" +
                objectives + " bands");
  EXPECT_EQ(explored["known"][0]["bands"].size(), 14U);
}

TEST(KeysOfAShard, AreThePromisedOnes) {
  const TemporaryFolder folder;
  reeve({"explore", "--fingers", "2", "--shard", "1/2", "--constraint", "sheaths<=2", "--out",
         folder.path().string()});
  const Json json = Json::parse(read_text(folder.path() / "shard.json"));
  EXPECT_EQ(
      keys(json),
      "exploration whole shard partial arguments total generated evaluated "
      "without_tensions unconverged seconds constraint_failures reaches known kept equals_left_out tradeoff sample settings version "
      "digest");
  EXPECT_EQ(keys(json["reaches"][0]), "met_by_any nearest nearest_with_the_others_met");
  EXPECT_EQ(keys(json["reaches"][0]["nearest"]), "below above");
  EXPECT_EQ(keys(json["known"][0]), "dominated_by generated rejected_by");
  EXPECT_EQ(keys(json["sample"]), "places routings");
  EXPECT_EQ(json["arguments"].dump(), R"(["--fingers=2","--constraint=sheaths<=2"])");
  EXPECT_EQ(keys(json["settings"]), keys(summary()["settings"]));
}

TEST(KeysOfAStoreRankedAgain, AreThePromisedOnes) {
  const TemporaryFolder folder;
  const std::string store = (folder.path() / "s.db").string();
  reeve({"explore", "--store", store, "--top", "10", "--out", folder.path().string()});
  const Json json = json_of({"rank", "--store", store, "--objectives", "travel"});
  EXPECT_EQ(keys(json),
            "exact inexact_because partial notes total generated evaluated kept failed_constraints "
            "front_equals_left_out front top tradeoff never_jams settings version");
  EXPECT_EQ(json["inexact_because"].size(), 1U);
  EXPECT_EQ(keys(json["top"][0]), keys(summary()["top"][0]));
}

TEST(KeysOfTheTradeoff, AreThePromisedOnes) {
  const std::string prices = (std::filesystem::path(REEVE_CATALOG_DIR) / "prices/example.toml");
  const Json json = summary({"--cost", prices, "--within", "5%", "--parts", "full"});
  EXPECT_EQ(keys(json["tradeoff"]), "by within affordable floating_blocks knee steps");
  EXPECT_EQ(keys(json["tradeoff"]["affordable"]), "routing name rank losses" + objectives);
  const Json& steps = json["tradeoff"]["steps"];
  EXPECT_EQ(keys(steps[1]), "at_most routing name rank kept gains losses" + objectives);
  EXPECT_EQ(keys(steps[1]["gains"]), "uniformity_mean efficiency_mean");
  EXPECT_EQ(keys(steps[1]["losses"]), "uniformity_mean efficiency_mean");
  EXPECT_TRUE(steps[0]["gains"].is_null());
  EXPECT_EQ(json["settings"]["tradeoff"].dump(), R"({"by":"cost","within":0.05})");
  EXPECT_EQ(keys(json["settings"]["prices"]),
            "unit sheath tube tip_bearing fixed_pulley movable_pulley block bar anchor fixed_end "
            "knot tendon_mm");
  EXPECT_EQ(keys(json_of({"rank", "--catalogue"})["tradeoff"]), keys(json["tradeoff"]));
}

TEST(KeysOfTheLeftOutParts, AreThePromisedOnes) {
  EXPECT_TRUE(summary()["left_out"].is_null());
  const Json json = json_of({"count", "--fingers", "5"});
  EXPECT_EQ(keys(json["parts"]), "tips joins ends anchored blocks");
  EXPECT_EQ(json["left_out"].dump(),
            R"({"anchored":false,"from_blocks":2,"to_blocks":4,"routings":5333880,)"
            R"("limit":2000000})");
}

TEST(KeysOfUnmetConstraints, AreThePromisedOnes) {
  const Json json = summary({"--constraint", "sheaths<=0"});
  ASSERT_EQ(json["unmet"].size(), 1U);
  EXPECT_EQ(json["unmet"][0].dump(),
            R"({"constraint":"sheaths<=0","met_by_any":false,"nearest":{"below":null,"above":1.0},)"
            R"("nearest_with_the_others_met":{"below":null,"above":1.0}})");
  EXPECT_TRUE(json["tradeoff"]["steps"].empty());
  EXPECT_TRUE(summary()["unmet"].empty());
}

TEST(KeysOfTheExploreSummary, NameEveryConstraintThatRejects) {
  const Json json = summary({"--constraint", "sheaths<=2", "--constraint", "jams == 0"});
  EXPECT_EQ(keys(json["rejected"]), "not actuated constraint sheaths<=2 constraint jams==0");
  EXPECT_EQ(json["settings"]["constraints"].dump(), R"(["sheaths<=2","jams==0"])");
}

TEST(KeysOfTheExploreSummary, HaveNullRankForAKnownRoutingThatIsNotAmongTheDesigns) {
  const Json json = summary({"--constraint", "sheaths<=1"});
  const Json tr7 = json["known"][6];
  ASSERT_EQ(tr7["name"], "TR7");
  EXPECT_TRUE(tr7["rank"].is_null());
  EXPECT_TRUE(tr7["front"].is_null());
  EXPECT_EQ(tr7["dominated_by"], 0);
}

}  // namespace
}  // namespace reeve::testing
