// An alias is one if the other cause, with a parameter of its own, makes the same readings.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/support/planting_alias.hpp"
#include "tests/support/planting_readings.hpp"

namespace reeve::testing {
namespace {

double greatest_difference(const Planted& planted, const Truth& other) {
  const Readings readings = expected_readings(other, planted.experiment);
  double greatest = 0;
  std::size_t row = 0, at = 0;
  for (const PlantedCell& cell : planted.cells) {
    at = cell.row == row ? at : 0;
    row = cell.row;
    greatest = std::max(greatest, std::abs(cell.expected_N - readings[row][at++]));
  }
  return greatest;
}

// A seed whose truth is that one.
PlantedAlias alias_with_truth(AliasKind kind, const std::string& truth) {
  for (std::uint64_t seed = 1; seed < 50; ++seed) {
    PlantedAlias alias = plant_alias(kind, low_noise, seed);
    if (alias.names[0] == truth) return alias;
  }
  ADD_FAILURE() << "no alias with truth " << truth;
  return {};
}

void expect_alias(const PlantedAlias& alias, const Truth& other) {
  EXPECT_LT(greatest_difference(alias.aliased, other), 1e-6);
  EXPECT_GT(greatest_difference(alias.separated, other), 0.1);
  EXPECT_GT(alias.aliased.log_likelihood_ratio, 20);
  EXPECT_TRUE(alias.separated.csv.size() > alias.aliased.csv.size());
}

TEST(PlantedAlias, OneSpeedAndOneTemperature) {
  const auto alias = alias_with_truth(AliasKind::speed_or_temperature, "speed_dependent_friction");
  const Condition& one = alias.aliased.experiment.rows[0].condition;
  Truth other;
  other.nature.temperature_slope_per_K = -alias.aliased.causes[0].parameters[0].value *
                                         std::log(*one.speed_mm_s / 10) / (*one.temperature_C - 20);
  expect_alias(alias, other);
}

TEST(PlantedAlias, OneCycleAndOneTemperature) {
  const auto alias = alias_with_truth(AliasKind::temperature_or_wear, "temperature");
  const Condition& one = alias.aliased.experiment.rows[0].condition;
  Truth other;
  other.nature.wear_change = -alias.aliased.causes[0].parameters[0].value *
                             (*one.temperature_C - 20) / (1 - std::exp(-*one.cycle / 500));
  expect_alias(alias, other);
}

TEST(PlantedAlias, SheathsOfOneFinger) {
  const auto alias = alias_with_truth(AliasKind::sheath_friction_or_angle, "sheath_friction");
  Truth other;
  other.nature.sheath_change_rad[1] =
      2 * std::numbers::pi * (alias.aliased.causes[0].parameters[0].value / 0.18 - 1);
  expect_alias(alias, other);
}

TEST(PlantedAlias, OneValueOfAChannel) {
  const auto alias = alias_with_truth(AliasKind::gain_or_offset, "sensor_gain[T2]");
  Truth other;
  for (const PlantedCell& cell : alias.aliased.cells) {
    if (cell.channel == "T2") other.sensors.offset_N["T2"] = cell.expected_N - cell.nominal_N;
  }
  expect_alias(alias, other);
}

TEST(PlantedAlias, OneTubePulledOneWay) {
  const auto alias = alias_with_truth(AliasKind::tube_friction_or_gain, "tube_friction");
  Truth other;
  other.sensors.gain["T2"] =
      std::exp(std::numbers::pi * (0.18 - alias.aliased.causes[0].parameters[0].value));
  expect_alias(alias, other);
}

TEST(PlantedAlias, FurtherRunsAreAddedToTheSameReadings) {
  for (const AliasKind kind : alias_kinds()) {
    const auto alias = plant_alias(kind, high_noise, 9);
    ASSERT_LT(alias.aliased.cells.size(), alias.separated.cells.size());
    for (std::size_t i = 0; i < alias.aliased.cells.size(); ++i) {
      EXPECT_EQ(alias.aliased.cells[i].reading_N, alias.separated.cells[i].reading_N);
    }
  }
}

}  // namespace
}  // namespace reeve::testing
