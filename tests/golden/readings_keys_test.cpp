// The keys of the JSON about measured tensions, which docs/schema promises to keep.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/golden/json_keys.hpp"

namespace reeve::testing {
namespace {

TEST(KeysOfCompare, AreThePromisedOnes) {
  const Json json = json_of({"compare", readings});
  EXPECT_EQ(keys(json), "data fitted tension share notes settings version result_id");
  EXPECT_EQ(keys(json["data"]), "file simulated readings runs routings channels covariates");
  EXPECT_EQ(keys(json["data"]["routings"][0]), "routing name");
  EXPECT_EQ(json["fitted"], false);
  for (const char* quantity : {"tension", "share"}) {
    const Json& summary = json[quantity];
    EXPECT_EQ(keys(summary), "all by_routing by_channel by_grasp by_direction by_run by_group");
    EXPECT_TRUE(summary["by_group"].empty());
    for (const Json& groups : summary) {
      if (groups.empty()) continue;
      EXPECT_EQ(keys(groups.is_array() ? groups[0] : groups),
                "group count mean_measured mean_residual rms relative_rms");
    }
  }
  EXPECT_EQ(keys(json["notes"][0]), "kind text lines");
  EXPECT_EQ(keys(json["settings"]), "hardware model");
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

const std::string held_out_keys =
    "rms_before rms_after reduction low high log_likelihood_gain gain_low gain_high expected_gain";
const std::string measurement_keys =
    "routing name held direction motor_tension_N speed_mm_s cycle temperature_C readings why expected "
    "expected_log_likelihood parameter width_now width_expected";

TEST(KeysOfDiagnose, AreThePromisedOnes) {
  const Json json = json_of({"diagnose", diagnosed + "cause.csv"});
  EXPECT_EQ(
      keys(json),
      "verdict causes laws indistinguishable separating_measurement unexplained leads residuals "
      "next_measurement held_out held_out_by_run noise_limit not_confirmed folds apart weighed structure share_errors left_out_runs "
      "losses without_apart published noise mountings row_scatter coefficients by_group ranking simulated too_few rows runs "
      "held_out_runs dropped_duplicates thinned_rows calibration notes seconds settings "
      "version result_id");
  const Json& cause = json["causes"][0];
  EXPECT_EQ(
      keys(cause),
      "name meaning detail explained parameters held_out only_run p_value evidence probability folds "
      "runner_up partial_residuals");
  EXPECT_EQ(keys(cause["parameters"][0]), "name value low high nominal unit at_bound literature");
  EXPECT_EQ(keys(cause["held_out"]), held_out_keys);
  EXPECT_TRUE(cause["runner_up"].is_null());
  EXPECT_EQ(keys(cause["explained"]), "rms share");
  const Json& partial = cause["partial_residuals"];
  EXPECT_EQ(keys(partial), "x y points curve left_out thinned");
  EXPECT_EQ(keys(partial["x"]), "name unit");
  EXPECT_EQ(keys(partial["points"]), "x y deviation run line held_out");
  EXPECT_EQ(keys(partial["curve"]), "x y low high");
  EXPECT_EQ(keys(json["residuals"]), "before after");
  EXPECT_EQ(keys(json["held_out"]), held_out_keys);
  EXPECT_EQ(keys(json["held_out_by_run"][0]), "run values rms_before rms_after rms_noise");
  EXPECT_EQ(keys(json["noise_limit"]), "log_likelihood_gain low high rms");
  EXPECT_EQ(keys(json["next_measurement"]), measurement_keys);
  EXPECT_EQ(keys(json["weighed"][0]), "name log_likelihood_gain held_out");
  EXPECT_EQ(keys(json["structure"][0]), "about rms statistic p_value");
  EXPECT_EQ(keys(json["noise"]),
            "relative absolute_N source degrees_of_freedom within_mountings of_group");
  EXPECT_EQ(keys(json["mountings"]), "mounted_again given bounded sheath tube bearing gain");
  EXPECT_EQ(keys(json["coefficients"][0]),
            "name parameter value low high at_bound hardware p_value differs");
  EXPECT_EQ(keys(json["ranking"]), "changes before after");
  EXPECT_EQ(keys(json["calibration"]), "replicates family_wise_alpha p_value structure_p_value");
  EXPECT_EQ(keys(json["settings"]), "data alpha hold_out seed generated_routings hardware terms");
}

TEST(KeysOfDiagnose, OfReadingsThatArePublishedAreThePromisedOnes) {
  const Json json = json_of({"diagnose", seeds_readings});
  EXPECT_EQ(keys(json["share_errors"]), "before after left_out routings");
  EXPECT_EQ(keys(json["share_errors"]["routings"][0]),
            "routing held rows held_out_rows before after left_out");
  EXPECT_EQ(keys(json["left_out_runs"][0]), "run causes");
  EXPECT_EQ(keys(json["left_out_runs"][0]["causes"][0]), "name parameters");
  EXPECT_EQ(
      keys(json["losses"][0]),
      "routing held direction from to over rows measured deviation before after stands_apart");
  EXPECT_EQ(keys(json["laws"][0]["runner_up"]), "name delta_log_likelihood");
  EXPECT_TRUE(json["without_apart"].is_null());
  EXPECT_EQ(keys(json["published"][0]), "name mu error equations_error lines other_losses");
  EXPECT_EQ(keys(json["published"][0]["lines"][0]), "source shares error equations_error");
  EXPECT_EQ(keys(json["published"][0]["other_losses"][0]),
            "from to loss printed equations sheaths sheaths_drawn");
}

TEST(KeysOfDiagnose, HaveNullWhereThereIsNoSuchThing) {
  const Json none = json_of({"diagnose", diagnosed + "none.csv"});
  for (const char* key :
       {"separating_measurement", "unexplained", "next_measurement", "held_out", "ranking"}) {
    EXPECT_TRUE(none[key].is_null()) << key;
  }
  EXPECT_TRUE(none["causes"].empty());
  EXPECT_TRUE(none["by_group"].empty());
  EXPECT_TRUE(none["noise"]["of_group"].empty());
  const Json several = json_of({"diagnose", diagnosed + "indistinguishable.csv"});
  EXPECT_EQ(keys(several["separating_measurement"]), measurement_keys);
  EXPECT_TRUE(several["separating_measurement"]["parameter"].is_null());
}

}  // namespace
}  // namespace reeve::testing
