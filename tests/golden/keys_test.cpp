// The keys of the JSON interface, which docs/json.md promises to keep: names and order. Those about
// measured tensions are in readings_keys_test.cpp.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/golden/json_keys.hpp"

namespace reeve::testing {
namespace {

const std::string objectives =
    " uniformity efficiency force_transmission jams sheaths pulleys knots travel "
    "round_trip_efficiency return_friction adaptability torsional_balance reliability authors_efficiency transmission score "
    "blocks finger_uniformity parts cost";
const std::string alike = " alike same_as place";
const std::string judged_settings = "objectives score grasps hardware model uncertainty";
const std::string common_settings = judged_settings + " ladder prices sweep";

void expect_pair(const Json& json) {
  EXPECT_EQ(keys(json["uniformity"]), "mean worst");
  EXPECT_EQ(keys(json["efficiency"]), "mean worst");
}

void expect_settings(const Json& settings) {
  EXPECT_EQ(keys(settings["grasps"][0]), "held weight");
  EXPECT_EQ(keys(settings["hardware"]), "tube bearing sheath lengths fingers contacts");
  EXPECT_EQ(keys(settings["hardware"]["tube"]), "mu angle_rad");
  EXPECT_EQ(keys(settings["hardware"]["lengths"]), "strand_mm motor_side_mm hand_mm");
}

TEST(KeysOfShow, AreThePromisedOnes) {
  const Json json = json_of({"show", "TR5", "--held", "1"});
  EXPECT_EQ(keys(json),
            "routing name canonical direction motor_sides grasps" + objectives + " model");
  EXPECT_TRUE(json["model"].is_null());
  EXPECT_EQ(keys(json["grasps"][0]),
            "held jams tensions shares contacts uniformity efficiency force_transmission");
  EXPECT_EQ(keys(json["grasps"][0]["tensions"]), "a T1 T2 b c T3 T4 d");
  EXPECT_EQ(keys(json["grasps"][0]["shares"]), "T1 T2 T3 T4");
  EXPECT_EQ(keys(json["grasps"][0]["contacts"][0]), "between kind slides");
  expect_pair(json);
}

constexpr const char* example_hand = REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml";
const std::string hand_objectives = "motor_force fingertip_force stroke closure motor_power";

TEST(KeysOfShow, AddAHandWhereTheHardwareHasOne) {
  const Json json = json_of({"show", "M-1-T-2-T-3-F", "--hardware", example_hand});
  EXPECT_EQ(keys(json),
            "routing name canonical direction motor_sides grasps" + objectives + " hand model");
  const Json& hand = json["hand"];
  EXPECT_EQ(keys(hand), hand_objectives + " fingers grasps motor");
  EXPECT_EQ(keys(hand["fingertip_force"]), "mean worst");
  EXPECT_EQ(keys(hand["fingers"][0]), "finger wanted_N excursion_mm closed");
  EXPECT_EQ(keys(hand["grasps"][0]), "held motor_force_N frictionless_N weakest fingers");
  EXPECT_EQ(keys(hand["grasps"][0]["fingers"][0]),
            "finger pull_per_motor force_per_motor asks_motor_N force_N joint force_at_limit_N");
  EXPECT_EQ(keys(hand["motor"]),
            "force_N frictionless_N friction_cost weakest stroke_mm closure speed_mm_s power_W "
            "work_J springs_J friction_J fingers_J torque_Nm spool_rpm force_is_enough "
            "stroke_is_enough force_reach stroke_reach");
  EXPECT_EQ(keys(hand["motor"]["force_reach"]), "motor_N share_of_wanted weakest");
  EXPECT_EQ(keys(hand["motor"]["force_reach"]["weakest"]), "finger joint held force_N");
  EXPECT_EQ(keys(hand["motor"]["stroke_reach"]), "stroke_mm closure closed");
  EXPECT_EQ(keys(hand["motor"]["weakest"]), "finger joint held");
}

TEST(KeysOfRank, AddAHandWhereTheHardwareHasOne) {
  const Json json = json_of({"rank", "M-1-T-2-T-3-F", "--hardware", example_hand});
  EXPECT_EQ(keys(json["designs"][0]), "rank front routing name" + objectives + " hand" + alike);
  EXPECT_EQ(keys(json["designs"][0]["hand"]), hand_objectives);
  const Json& hardware = json["settings"]["hardware"];
  EXPECT_EQ(keys(hardware), "tube bearing sheath lengths fingers contacts hand motor");
  EXPECT_EQ(keys(hardware["hand"]), "force_N joints");
  EXPECT_EQ(keys(hardware["hand"]["joints"][0]),
            "arm_mm range_deg lever_mm spring_Nmm_rad rest_deg held_deg");
  EXPECT_EQ(keys(hardware["fingers"][0]), "finger closing force_N joints");
  EXPECT_EQ(keys(hardware["motor"]), "spool_radius_mm close_s force_N stroke_mm");
}

TEST(KeysOfShow, HaveNullWhereNoMotorForceIsEnough) {
  const Json hand = json_of({"show", "M-1-M+M-2-M+M-3-M", "--hardware", example_hand})["hand"];
  EXPECT_TRUE(hand["motor_force"].is_null());
  EXPECT_TRUE(hand["motor"]["force_N"].is_null());
  EXPECT_TRUE(hand["grasps"][1]["fingers"][1]["asks_motor_N"].is_null());
  EXPECT_TRUE(hand["grasps"][1]["fingers"][1]["joint"].is_null());
  EXPECT_EQ(hand["motor"]["force_is_enough"], false);
}

TEST(KeysOfShow, AddPricesWhereTheyAreGiven) {
  const Json json = json_of({"show", "TR5", "--cost", REEVE_CATALOG_DIR "/prices/example.toml"});
  EXPECT_EQ(keys(json),
            "routing name canonical direction motor_sides grasps" + objectives + " model prices");
  EXPECT_EQ(json["prices"]["unit"], "EUR");
}

TEST(KeysOfShow, HaveNullWhereThereIsNoNameOrNoNumber) {
  const Json json = json_of({"show", "M-F"});
  EXPECT_TRUE(json["name"].is_null());
  EXPECT_TRUE(json["uniformity"]["mean"].is_null());
  EXPECT_TRUE(json["uniformity"]["worst"].is_null());
  EXPECT_TRUE(json["grasps"][0]["uniformity"].is_null());
  EXPECT_TRUE(json["grasps"][0]["shares"].is_object());
  EXPECT_TRUE(json["grasps"][0]["shares"].empty());
}

TEST(KeysOfRank, AreThePromisedOnes) {
  const Json json = json_of({"rank", "--catalog"});
  EXPECT_EQ(keys(json), "designs settings ladder version");
  EXPECT_EQ(keys(json["designs"][0]), "rank front routing name" + objectives + alike);
  EXPECT_EQ(keys(json["settings"]), common_settings);
  EXPECT_TRUE(json["settings"]["uncertainty"].is_null());
  expect_pair(json["designs"][0]);
  expect_settings(json["settings"]);
}

void expect_model(const Json& model) {
  EXPECT_EQ(keys(model), "effects conditions unconverged");
  EXPECT_EQ(keys(model["effects"][0]), "cause subject values in_designs");
  EXPECT_EQ(model["effects"][0]["cause"], "tube_friction");
  EXPECT_EQ(model["effects"][0]["values"].dump(), R"({"mu":0.09})");
  EXPECT_EQ(model["effects"][2]["subject"].dump(), R"({"finger":2})");
  EXPECT_EQ(model["effects"][4]["in_designs"], false);
  EXPECT_EQ(keys(model["conditions"]), "motor_tension_N speed_mm_s cycle temperature_C");
  EXPECT_EQ(model["unconverged"], 0);
}

TEST(KeysOfTheModel, AreThePromisedOnes) {
  expect_model(json_of({"show", "TR1", "--model", example_model})["model"]);
  expect_model(json_of({"rank", "TR1", "--model", example_model})["settings"]["model"]);
  expect_model(summary({"--model", example_model})["settings"]["model"]);
}

TEST(KeysOfRank, AddADistributionWithUncertainty) {
  const Json json = json_of({"rank", "--catalog", "--uncertainty", "--draws", "5"});
  EXPECT_EQ(keys(json["designs"][0]),
            "rank front routing name" + objectives + alike + " rank_distribution bands");
  EXPECT_EQ(keys(json["designs"][0]["rank_distribution"]),
            "first_share median p5 p95 first_shared");
  EXPECT_EQ(keys(json["designs"][0]["bands"]),
            "uniformity_mean uniformity_worst efficiency_mean efficiency_worst force_transmission "
            "round_trip_efficiency adaptability torsional_balance reliability authors_efficiency "
            "transmission score finger_uniformity_mean finger_uniformity_worst");
  EXPECT_EQ(keys(json["designs"][0]["bands"]["score"]), "median p5 p95");
  EXPECT_EQ(keys(json["settings"]["uncertainty"]),
            "draws seed tube_mu sheath_mu bearing_mu_relative sheath_angle_relative");
}

TEST(KeysOfRank, AddTheMarginsOfTheFirstDesignIfAskedFor) {
  const Json json = json_of({"rank", "TR3", "TR7", "--margin"});
  EXPECT_EQ(keys(json), "designs settings ladder margins version");
  ASSERT_EQ(json["margins"].size(), 1U);
  EXPECT_EQ(json["margins"][0]["over"], "F-1-P-2-F");
  EXPECT_EQ(keys(json["margins"][0]), "over lead least_lead at");
  EXPECT_EQ(keys(json["margins"][0]["at"]), "tube_mu sheath_mu bearing_mu sheath_angle_rad");
}

TEST(KeysOfRank, AddWhatThePageShows) {
  const Json json = with_page({"rank", "TR5", "TR7", "--data", readings});
  EXPECT_EQ(keys(json),
            "designs settings ladder best routings tension_distributions measured_data version");
  EXPECT_EQ(keys(json["best"][0]), "objective value count routings");
  EXPECT_EQ(keys(json["routings"][0]), keys(json_of({"show", "TR7"})));
  ASSERT_EQ(json["tension_distributions"].size(), 6U);  // two coefficients in three grasps
  EXPECT_EQ(
      keys(json["tension_distributions"][0]),
      "mu friction tube_mu sheath_mu held rms_measured share_error published_share_error routings");
  const Json& routing = json["tension_distributions"][0]["routings"][0];
  EXPECT_EQ(keys(routing), "routing name published_source readings strands");
  EXPECT_EQ(keys(routing["strands"][0]),
            "strand model published published_fault measured measured_deviation");
  EXPECT_EQ(keys(json["measured_data"]), "file simulated notes");
  EXPECT_TRUE(with_page({"rank", "TR5"})["measured_data"].is_null());
}

TEST(KeysOfTheExploreSummary, AreThePromisedOnes) {
  const Json json = summary();
  EXPECT_EQ(keys(json),
            "generated rejected evaluated partial notes total seconds designs_per_second "
            "front_equals_left_out front top best known ladder unmet exploration settings version");
  EXPECT_EQ(keys(json["rejected"]), "not actuated");
  EXPECT_EQ(keys(json["front"][0]), "rank front routing name" + objectives + alike);
  EXPECT_EQ(keys(json["top"][0]), "rank front routing name" + objectives + alike);
  EXPECT_EQ(keys(json["known"][0]),
            "name routing rank front dominated_by generated rejected_by" + objectives);
  EXPECT_EQ(keys(json["settings"]),
            "fingers identical_fingers parts tendons shard top constraints " + common_settings);
  EXPECT_EQ(keys(json["settings"]["parts"]), "tips joins ends anchored blocks");
  expect_pair(json["known"][0]);
  expect_settings(json["settings"]);
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
      "exploration whole shard partial arguments total generated evaluated unconverged seconds "
      "constraint_failures reaches known kept equals_left_out ladder sample settings version");
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
  reeve({"explore", "--store", store, "--out", folder.path().string()});
  const Json json = json_of({"rank", "--store", store, "--objectives", "travel"});
  EXPECT_EQ(keys(json),
            "exact inexact_because partial total generated evaluated kept failed_constraints "
            "front_equals_left_out front top ladder settings version");
  EXPECT_EQ(json["inexact_because"].size(), 1U);
  EXPECT_EQ(keys(json["top"][0]), keys(summary()["top"][0]));
}

TEST(KeysOfTheLadder, AreThePromisedOnes) {
  const std::string prices = (std::filesystem::path(REEVE_CATALOG_DIR) / "prices/example.toml");
  const Json json = summary({"--cost", prices, "--within", "5%"});
  EXPECT_EQ(keys(json["ladder"]), "by within affordable knee rungs");
  EXPECT_EQ(keys(json["ladder"]["affordable"]), "routing name rank losses" + objectives);
  const Json& rungs = json["ladder"]["rungs"];
  EXPECT_EQ(keys(rungs[1]), "at_most routing name rank kept gains losses" + objectives);
  EXPECT_EQ(keys(rungs[1]["gains"]), "uniformity_mean efficiency_mean");
  EXPECT_EQ(keys(rungs[1]["losses"]), "uniformity_mean efficiency_mean");
  EXPECT_TRUE(rungs[0]["gains"].is_null());
  EXPECT_EQ(json["settings"]["ladder"].dump(), R"({"by":"cost","within":0.05})");
  EXPECT_EQ(keys(json["settings"]["prices"]),
            "unit sheath tube tip_bearing fixed_pulley movable_pulley block bar anchor fixed_end "
            "knot tendon_mm");
  EXPECT_EQ(keys(json_of({"rank", "--catalog"})["ladder"]), keys(json["ladder"]));
}

TEST(KeysOfUnmetConstraints, AreThePromisedOnes) {
  const Json json = summary({"--constraint", "sheaths<=0"});
  ASSERT_EQ(json["unmet"].size(), 1U);
  EXPECT_EQ(json["unmet"][0].dump(),
            R"({"constraint":"sheaths<=0","met_by_any":false,"nearest":{"below":null,"above":1.0},)"
            R"("nearest_with_the_others_met":{"below":null,"above":1.0}})");
  EXPECT_TRUE(json["ladder"]["rungs"].empty());
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

TEST(KeysOfSize, AreThePromisedOnes) {
  const Json json = json_of(sizing);
  EXPECT_EQ(keys(json), "designs partial notes settings version");
  const Json& design = json["designs"][0];
  EXPECT_EQ(keys(design),
            "rank rank_before routing name target dimensions together flat before sized hardware");
  EXPECT_EQ(keys(design["target"]), "met least_miss nearest_shares");
  EXPECT_EQ(keys(design["dimensions"][0]),
            "dimension unit bounds before sized at_bound slope tolerance tolerance_together");
  EXPECT_EQ(keys(design["dimensions"][0]["tolerance_together"]), "less more");
  EXPECT_EQ(keys(design["together"]), "factor worst");
  EXPECT_EQ(keys(design["dimensions"][0]["slope"]), "less more");
  EXPECT_EQ(keys(design["dimensions"][0]["tolerance"]), "less more");
  EXPECT_EQ(keys(design["flat"][0]), "moves loss");
  EXPECT_EQ(keys(design["flat"][0]["moves"][0]), "dimension by");
  EXPECT_EQ(keys(design["sized"]), "goal nominal_goal finger_shares" + objectives);
  EXPECT_EQ(keys(json["settings"]),
            "goal target_shares better robust vary same starts evaluations " + judged_settings);
  EXPECT_EQ(keys(json["settings"]["vary"][0]), "dimension bounds");
}

TEST(KeysOfSize, AddWhatThePageShows) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments = sizing;
  arguments.insert(arguments.end(), {"--out", folder.path().string()});
  EXPECT_EQ(reeve(arguments).exit_code, 0);
  const Json json = Json::parse(read_text(folder.path() / "sizing.json"));
  EXPECT_EQ(keys(json), "designs details partial notes settings version");
  EXPECT_EQ(keys(json["details"]), "before sized profiles");
  EXPECT_EQ(keys(json["details"]["profiles"][0]), "dimension values goals");
}

TEST(KeysOfSize, HaveNullWhereThereIsNoSuchThing) {
  const Json json = json_of({"size", "M-1-T-2-F", "--vary", "sheath_angle=3..9", "--nominal"});
  const Json& design = json["designs"][0];
  EXPECT_TRUE(design["target"].is_null());
  EXPECT_EQ(design["dimensions"][0]["at_bound"], "low");
  EXPECT_TRUE(design["dimensions"][0]["tolerance"]["less"].is_null());
  EXPECT_TRUE(json["settings"]["target_shares"].is_null());
  EXPECT_TRUE(json["settings"]["uncertainty"].is_null());
}

TEST(KeysOfCount, AreThePromisedOnes) {
  EXPECT_EQ(keys(json_of({"count"})), "all actuated one_tendon");
}

TEST(KeysOfCheck, AreThePromisedOnes) {
  const Json json = json_of({"check"});
  EXPECT_EQ(keys(json), "checks misprints agrees used explained open differs families version");
  EXPECT_EQ(keys(json["misprints"][0]), "family routing source text");
  for (const Json& check : json["checks"]) {
    EXPECT_EQ(keys(check),
              "family routing source quantity published computed status inferred_from reason");
    EXPECT_EQ(check["reason"].is_null(), check["status"] == "agrees" || check["status"] == "used");
    if (check["status"] == "used") {
      EXPECT_FALSE(check["inferred_from"].is_null());
    }
  }
  std::size_t differing = 0;
  for (const Json& family : json["families"]) {
    EXPECT_EQ(keys(family), "family agrees used explained open differs");
    differing += family["open"].get<std::size_t>();
  }
  EXPECT_EQ(json["open"], differing);
}

}  // namespace
}  // namespace reeve::testing
