#include "tests/support/planting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "readings/measured_data.hpp"
#include "tests/support/planting_readings.hpp"
#include "tests/support/planting_walk.hpp"

namespace reeve::testing {
namespace {

MeasuredData parse(const std::string& csv) {
  return parse_measured_data(csv, "planted.csv",
                             [](const std::string& word) { return parse_routing(word); });
}

Planted plant_one(EffectKind kind, EffectSize size, std::uint64_t seed) {
  return plant({{kind}, size, low_noise}, seed);
}

// Two readings of M-1-F at 20 N, in one run.
Experiment two_rows() {
  Experiment experiment;
  experiment.channels = {"T1", "T2"};
  Condition condition;
  condition.word = "M-1-F";
  condition.motor_tension_N = 20;
  experiment.rows.assign(2, {"run 1", condition, {"T1", "T2"}});
  return experiment;
}

TEST(Planting, SameSeedSameBytes) {
  const PlantingPlan plan{
      {EffectKind::tube_friction, EffectKind::sensor_gain}, EffectSize::medium, high_noise};
  const std::string csv = plant(plan, 5).csv;
  EXPECT_EQ(plant(plan, 5).csv, csv);
  EXPECT_NE(plant(plan, 6).csv, csv);
}

TEST(Planting, EveryEffectCanBeReadAsMeasuredData) {
  std::uint64_t seed = 1;
  for (const auto& kinds : {library_effects(), unknown_effects()}) {
    for (const EffectKind kind : kinds) {
      const Planted planted = plant_one(kind, EffectSize::medium, ++seed);
      SCOPED_TRACE(planted.causes.front().name);
      const MeasuredData data = parse(planted.csv);
      EXPECT_TRUE(data.simulated);
      EXPECT_EQ(data.readings.size(), planted.experiment.rows.size());
      EXPECT_TRUE(planted.causes.front().name.starts_with(planted_name(kind)));
      EXPECT_NEAR(planted.causes.front().log_likelihood_ratio, planted.log_likelihood_ratio, 1e-9);
    }
  }
}

TEST(Planting, FileHoldsTheReadingsThatItTellsOf) {
  const Planted planted = plant_one(EffectKind::pretension, EffectSize::large, 3);
  const MeasuredData data = parse(planted.csv);
  std::size_t readings = 0;
  for (const Reading& reading : data.readings) {
    readings +=
        static_cast<std::size_t>(std::count_if(reading.tension_N.begin(), reading.tension_N.end(),
                                               [](const auto& cell) { return cell.has_value(); }));
  }
  EXPECT_EQ(readings, planted.cells.size());
  for (const PlantedCell& cell : planted.cells) {
    const auto channel = std::find_if(data.channels.begin(), data.channels.end(),
                                      [&](const Channel& c) { return c.name == cell.channel; });
    const auto at = static_cast<std::size_t>(channel - data.channels.begin());
    EXPECT_EQ(data.readings[cell.row].tension_N[at], cell.reading_N);
  }
}

TEST(Planting, NothingHiddenIsTheNominalModel) {
  const Planted planted = plant({}, 11);
  EXPECT_TRUE(planted.causes.empty());
  EXPECT_EQ(planted.log_likelihood_ratio, 0);
  double squares = 0;
  for (const PlantedCell& cell : planted.cells) {
    EXPECT_EQ(cell.nominal_N, cell.expected_N);
    squares += std::pow(
        (cell.reading_N - cell.expected_N) / standard_deviation(planted.noise, cell.expected_N), 2);
  }
  EXPECT_NEAR(squares / static_cast<double>(planted.cells.size()), 1, 0.15);
}

TEST(Planting, ReadingsAreAboveTheNoise) {
  for (const EffectKind kind : {EffectKind::bending_stiffness, EffectKind::sensor_offset}) {
    const Planted planted = plant({{kind}, EffectSize::large, high_noise}, 6);
    EXPECT_GT(planted.cells.size(), 200U);
    for (const PlantedCell& cell : planted.cells) EXPECT_GE(cell.expected_N, 0.15);
  }
}

TEST(Planting, LargeEffectsAreSeenByTheOracle) {
  for (const EffectKind kind :
       {EffectKind::tube_friction, EffectKind::load_dependent_friction, EffectKind::wear,
        EffectKind::bending_stiffness, EffectKind::crosstalk, EffectKind::wave}) {
    const double small = plant_one(kind, EffectSize::small, 4).log_likelihood_ratio;
    const double large = plant_one(kind, EffectSize::large, 4).log_likelihood_ratio;
    EXPECT_GT(large, small) << planted_name(kind);
    EXPECT_GT(large, 20) << planted_name(kind);
  }
}

TEST(Planting, TruthFitsBetterThanTheNominalModel) {
  const Planted planted = plant_one(EffectKind::sheath_friction, EffectSize::large, 8);
  EXPECT_LT(planted.rms_to_truth_N(), 0.5 * planted.rms_to_nominal_N());
}

TEST(Planting, EachOfTwoCausesHasItsOwnRatio) {
  const Planted planted = plant(
      {{EffectKind::tube_friction, EffectKind::sensor_offset}, EffectSize::large, low_noise}, 2);
  ASSERT_EQ(planted.causes.size(), 2U);
  for (const PlantedCause& cause : planted.causes) {
    EXPECT_GT(cause.log_likelihood_ratio, 0) << cause.name;
    EXPECT_NE(cause.log_likelihood_ratio, planted.log_likelihood_ratio) << cause.name;
  }
}

TEST(Planting, CopiedRunsAreNotedAsDuplicates) {
  const Planted planted = plant({}, 12);
  const MeasuredData clean = parse(planted.csv);
  const MeasuredData copied = parse(with_copied_runs(planted, 2));
  const auto across_runs = [](const MeasuredData& data) {
    return std::count_if(data.notes.begin(), data.notes.end(), [](const DataNote& note) {
      return note.kind == NoteKind::duplicate_across_runs;
    });
  };
  EXPECT_EQ(across_runs(clean), 0);
  EXPECT_GT(across_runs(copied), 0);
  EXPECT_EQ(copied.runs.size(), clean.runs.size() + 2);
}

TEST(Sensors, ReadGainOffsetAndPretension) {
  const Experiment experiment = two_rows();
  const double nominal = expected_readings({}, experiment)[0][0];
  Truth truth;
  truth.sensors.gain["T1"] = 1.1;
  truth.sensors.offset_N["T1"] = -0.3;
  truth.sensors.pretension_N = 0.2;
  const Readings readings = expected_readings(truth, experiment);
  EXPECT_NEAR(readings[0][0], 1.1 * (nominal + 0.2) - 0.3, 1e-12);
  EXPECT_NEAR(readings[0][1], expected_readings({}, experiment)[0][1] + 0.2, 1e-12);
}

TEST(Sensors, ReadTheirNeighbourToo) {
  Truth truth;
  truth.sensors.crosstalk = 0.1;
  const Readings nominal = expected_readings({}, two_rows());
  const Readings readings = expected_readings(truth, two_rows());
  EXPECT_NEAR(readings[0][0], nominal[0][0] + 0.1 * nominal[0][1], 1e-12);
  EXPECT_EQ(readings[0][1], nominal[0][1]);
}

TEST(Sensors, DriftAndSwingWithTheOrderOfRows) {
  Truth drifting, swinging;
  drifting.sensors.drift = 0.4;
  swinging.sensors.wave_amplitude = 0.2;
  swinging.sensors.wave_period_rows = 4;
  const Readings nominal = expected_readings({}, two_rows());
  EXPECT_EQ(expected_readings(drifting, two_rows())[0], nominal[0]);
  EXPECT_NEAR(expected_readings(drifting, two_rows())[1][0], 1.2 * nominal[1][0], 1e-12);
  EXPECT_NEAR(expected_readings(swinging, two_rows())[1][0], 1.2 * nominal[1][0], 1e-12);
}

}  // namespace
}  // namespace reeve::testing
