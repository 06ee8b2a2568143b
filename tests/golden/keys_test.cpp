// The keys of the JSON interface, which docs/schema promises to keep: names and order. Those about
// measured tensions are in readings_keys_test.cpp, those of an exploration in
// explore_keys_test.cpp.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/golden/design_keys.hpp"

namespace reeve::testing {
namespace {

TEST(KeysOfShow, AreThePromisedOnes) {
  const Json json = json_of({"show", "TR5", "--held", "1"});
  EXPECT_EQ(keys(json), "routing name canonical direction motor_sides trees grasps" + objectives +
                            " smallest_jams model result_id");
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
  EXPECT_EQ(keys(json), "routing name canonical direction motor_sides trees grasps" + objectives +
                            " hand smallest_jams model result_id");
  const Json& hand = json["hand"];
  EXPECT_EQ(keys(hand), hand_objectives + " fingers grasps motor");
  EXPECT_EQ(keys(hand["fingertip_force"]), "mean worst");
  EXPECT_EQ(keys(hand["fingers"][0]), "finger wanted_N excursion_mm closed");
  EXPECT_EQ(keys(hand["grasps"][0]), "held motor_force_N frictionless_N weakest fingers");
  EXPECT_EQ(keys(hand["grasps"][0]["fingers"][0]),
            "finger pull_per_motor force_per_motor asks_motor_N force_N joint force_at_limit_N");
  EXPECT_EQ(
      keys(hand["motor"]),
      "force_N frictionless_N friction_cost weakest stroke_mm closure speed_mm_s power_W "
      "work_J springs_J friction_J fingers_J torque_Nm spool_rpm drawn force_reach stroke_reach");
  EXPECT_EQ(keys(hand["motor"]["drawn"]),
            "nominal_N p95_N draws seed is_enough stroke_mm stroke_is_enough");
  EXPECT_EQ(keys(hand["motor"]["force_reach"]), "motor_N share_of_wanted weakest");
  EXPECT_EQ(keys(hand["motor"]["force_reach"]["weakest"]), "finger joint held force_N");
  EXPECT_EQ(keys(hand["motor"]["stroke_reach"]), "stroke_mm closure closed");
  EXPECT_EQ(keys(hand["motor"]["weakest"]), "finger joint held");
}

TEST(KeysOfShow, AddTheForceAndStrokeOfEachOfSeveralMotors) {
  const Json json = json_of({"show", "M-1-T-2-F+M2-3-F", "--hardware", example_hand});
  const Json& drawn = json["hand"]["motor"]["drawn"];
  EXPECT_EQ(keys(drawn), "nominal_N p95_N draws seed is_enough stroke_mm stroke_is_enough motors");
  ASSERT_EQ(drawn["motors"].size(), 2U);
  EXPECT_EQ(keys(drawn["motors"][1]), "motor force_N stroke_mm");
  EXPECT_EQ(drawn["motors"][1]["motor"], 2);
  EXPECT_EQ(keys(json["hand"]["motors_alone"][1]), "motor stroke_mm closed");
}

TEST(KeysOfRank, AddAHandWhereTheHardwareHasOne) {
  const Json json = json_of({"rank", "M-1-T-2-T-3-F", "--hardware", example_hand});
  EXPECT_EQ(keys(json["designs"][0]),
            "rank front routing name" + objectives + " hand" + equivalent);
  EXPECT_EQ(keys(json["designs"][0]["hand"]), hand_objectives);
  const Json& hardware = json["settings"]["hardware"];
  EXPECT_EQ(keys(hardware), "tube bearing sheath scatter lengths fingers contacts hand motor");
  EXPECT_EQ(keys(hardware["hand"]), "force_N joints");
  EXPECT_EQ(keys(hardware["hand"]["joints"][0]),
            "arm_mm range_deg lever_mm spring_Nmm_rad rest_deg held_deg");
  EXPECT_EQ(keys(hardware["fingers"][0]), "finger force_N joints");
  EXPECT_EQ(keys(hardware["motor"]), "spool_radius_mm close_s force_N stroke_mm");
}

TEST(KeysOfShow, HaveNullWhereNoMotorForceIsEnough) {
  const Json hand = json_of({"show", "M-1-M+M-2-M+M-3-M", "--hardware", example_hand})["hand"];
  EXPECT_TRUE(hand["motor_force"].is_null());
  EXPECT_TRUE(hand["motor"]["force_N"].is_null());
  EXPECT_TRUE(hand["grasps"][1]["fingers"][1]["asks_motor_N"].is_null());
  EXPECT_TRUE(hand["grasps"][1]["fingers"][1]["joint"].is_null());
  EXPECT_TRUE(hand["motor"]["drawn"]["nominal_N"].is_null());
  EXPECT_EQ(hand["motor"]["drawn"]["is_enough"], false);
}

TEST(KeysOfShow, AddAWrapAngleWhereTheWordGivesIt) {
  const Json contacts = json_of({"show", "M-1-T/90-2-F"})["grasps"][0]["contacts"];
  EXPECT_EQ(keys(contacts[1]), "between kind slides");
  EXPECT_EQ(keys(contacts[2]), "between kind slides angle_deg");
  EXPECT_EQ(contacts[2]["angle_deg"], 90);
}

TEST(KeysOfShow, AddPricesWhereTheyAreGiven) {
  const Json json = json_of({"show", "TR5", "--cost", REEVE_CATALOG_DIR "/prices/example.toml"});
  EXPECT_EQ(keys(json), "routing name canonical direction motor_sides trees grasps" + objectives +
                            " smallest_jams model prices result_id");
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
  const Json json = json_of({"rank", "--catalogue"});
  EXPECT_EQ(keys(json),
            "designs settings tradeoff never_jams robust_first motor version result_id");
  EXPECT_EQ(keys(json["designs"][0]), "rank front routing name" + objectives + equivalent);
  EXPECT_EQ(keys(json["settings"]), common_settings);
  EXPECT_TRUE(json["settings"]["uncertainty"].is_null());
  expect_pair(json["designs"][0]);
  expect_settings(json["settings"]);
}

void expect_model(const Json& model) {
  EXPECT_EQ(keys(model), "effects conditions outside_range unconverged");
  EXPECT_EQ(keys(model["effects"][0]), "cause subject values in_designs");
  EXPECT_EQ(model["effects"][0]["cause"], "tube_friction");
  EXPECT_EQ(model["effects"][0]["values"].dump(), R"({"mu":0.09})");
  EXPECT_EQ(model["effects"][2]["subject"].dump(), R"({"finger":2})");
  EXPECT_EQ(model["effects"][4]["in_designs"], false);
  EXPECT_EQ(keys(model["effects"].back()["subject"]), "site acts_on covariate form middle range");
  EXPECT_EQ(keys(model["conditions"]),
            "motor_tension_N speed_mm_s cycle temperature_C humidity_pct");
  EXPECT_EQ(model["outside_range"], Json::array());
  EXPECT_EQ(model["unconverged"], 0);
}

TEST(KeysOfTheModel, AreThePromisedOnes) {
  expect_model(json_of({"show", "TR1", "--model", example_model})["model"]);
  expect_model(json_of({"rank", "TR1", "--model", example_model})["settings"]["model"]);
  expect_model(summary({"--model", example_model})["settings"]["model"]);
}

TEST(KeysOfRank, AddADistributionWithUncertainty) {
  const Json json = json_of({"rank", "--catalogue", "--uncertainty", "--draws", "5"});
  EXPECT_EQ(keys(json["designs"][0]),
            "rank front routing name" + objectives + equivalent + " rank_distribution bands");
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
  EXPECT_EQ(keys(json),
            "designs settings tradeoff never_jams robust_first motor margins version result_id");
  ASSERT_EQ(json["margins"].size(), 1U);
  EXPECT_EQ(json["margins"][0]["over"], "F-1-P-2-F");
  EXPECT_EQ(keys(json["margins"][0]), "over lead least_lead at");
  EXPECT_EQ(keys(json["margins"][0]["at"]), "tube_mu sheath_mu bearing_mu sheath_angle_rad");
}

TEST(KeysOfRank, AddWhatThePageShows) {
  const Json json = with_page({"rank", "TR5", "TR7", "--data", readings});
  EXPECT_EQ(
      keys(json),
      "designs settings tradeoff never_jams robust_first motor best routings tension_distributions measured_data version result_id");
  EXPECT_EQ(keys(json["best"][0]), "objective value count routings");
  EXPECT_EQ(keys(json["routings"][0]) + " result_id", keys(json_of({"show", "TR7"})));
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

TEST(KeysOfSize, AreThePromisedOnes) {
  const Json json = json_of(sizing);
  EXPECT_EQ(keys(json), "designs partial notes settings version result_id");
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
  EXPECT_EQ(keys(design["sized"]), "goal nominal_goal finger_shares motor" + objectives);
  EXPECT_EQ(
      keys(json["settings"]),
      "goal target_shares better robust vary equal starts evaluations goal_grasps told_draws " +
          evaluated_settings);
  EXPECT_EQ(keys(json["settings"]["vary"][0]), "dimension bounds");
}

TEST(KeysOfSize, AddWhatThePageShows) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments = sizing;
  arguments.insert(arguments.end(), {"--out", folder.path().string()});
  EXPECT_EQ(reeve(arguments).exit_code, 0);
  const Json json = Json::parse(read_text(folder.path() / "sizing.json"));
  EXPECT_EQ(keys(json), "designs details partial notes settings version result_id");
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
  EXPECT_EQ(keys(json_of({"count"})), "all actuated one_tendon parts left_out");
}

TEST(KeysOfCheck, AreThePromisedOnes) {
  const Json json = json_of({"check"});
  EXPECT_EQ(keys(json),
            "checks misprints agrees used explained refuted open differs families version");
  EXPECT_EQ(keys(json["misprints"][0]), "family routing source text");
  for (const Json& check : json["checks"]) {
    EXPECT_EQ(keys(check),
              "family routing source quantity published computed status inferred_from reason");
    // A number that gave the coefficient of an expression has the expression as its reason.
    if (check["status"] == "used") {
      EXPECT_FALSE(check["inferred_from"].is_null());
    } else {
      EXPECT_EQ(check["reason"].is_null(), check["status"] == "agrees");
    }
  }
  std::size_t differing = 0;
  for (const Json& family : json["families"]) {
    EXPECT_EQ(keys(family), "family agrees used explained refuted open differs");
    differing += family["open"].get<std::size_t>();
  }
  EXPECT_EQ(json["open"], differing);
}

}  // namespace
}  // namespace reeve::testing
