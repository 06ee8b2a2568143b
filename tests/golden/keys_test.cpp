// The keys of the JSON interface, which docs/schema promises to keep: names and order, where no
// file in expected/ has them. Those of an exploration are in explore_keys_test.cpp.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/golden/json_keys.hpp"

namespace reeve::testing {
namespace {

constexpr const char* example_hand = REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml";

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
  EXPECT_EQ(keys(json["designs"][0]["hand"]),
            "motor_force fingertip_force stroke closure motor_power");
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

TEST(KeysOfRank, AddTheMarginsOfTheFirstDesignIfAskedFor) {
  const Json json = json_of({"rank", "TR3", "TR7", "--margin"});
  EXPECT_EQ(keys(json),
            "designs settings tradeoff never_jams robust_first motor margins version result_id");
  ASSERT_EQ(json["margins"].size(), 1U);
  EXPECT_EQ(json["margins"][0]["over"], "F-1-P-2-F");
  EXPECT_EQ(keys(json["margins"][0]), "over lead least_lead at");
  EXPECT_EQ(keys(json["margins"][0]["at"]), "tube_mu sheath_mu bearing_mu sheath_angle_rad");
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

TEST(KeysOfSize, HaveNullForTheUncertaintyOfANominalGoal) {
  const Json json = json_of({"size", "M-1-T-2-F", "--vary", "sheath_angle=3..9", "--nominal"});
  EXPECT_TRUE(json["settings"]["uncertainty"].is_null());
}

TEST(KeysOfRank, HaveNullWhereThereAreNoMeasuredData) {
  EXPECT_TRUE(with_page({"rank", "TR5"})["measured_data"].is_null());
}

TEST(KeysOfCompare, HaveNullWhereThereIsNothingToSummarise) {
  const Json json =
      json_of({"compare", std::string(REEVE_CATALOG_DIR) + "/measured/canyons_and_crags.csv"});
  EXPECT_FALSE(json["tension"].is_null());
  EXPECT_TRUE(json["share"].is_null());
  EXPECT_TRUE(json["notes"].empty());
}

TEST(KeysOfSimulateWithPower, AreThePromisedOnes) {
  const Json json = json_of(power);
  EXPECT_EQ(keys(json), "simulated experiments hidden findings trials settings version");
  EXPECT_EQ(keys(json["hidden"][0]), "cause size");
  EXPECT_EQ(keys(json["findings"]), "found wrong none unexplained indistinguishable");
  for (const Json& finding : json["findings"]) EXPECT_EQ(keys(finding), "count share low high");
  EXPECT_EQ(keys(json["trials"][0]), "seed finding causes indistinguishable");
  EXPECT_EQ(keys(json["settings"]), "command noise_relative noise_absolute_N hardware");
}

TEST(KeysOfAGuess, AreThePromisedOnes) {
  const Json json = Json::parse(reeve({"import", logged, "--guess", "--format", "json"}).out);
  EXPECT_EQ(keys(json),
            "file separator columns first_rows missing assumed can_be_imported command version");
  EXPECT_EQ(keys(json["columns"][0]), "name kind meaning reason");
  EXPECT_EQ(json["can_be_imported"], true);
}

}  // namespace
}  // namespace reeve::testing
