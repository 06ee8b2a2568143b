// What drives and sensors do to planted readings, by hand: one finger on one tendon, T1 = T_in
// e^-phi with phi = 0.18 2 pi pulling.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/planting_readings.hpp"

namespace reeve::testing {
namespace {

const double through = std::exp(-0.36 * std::numbers::pi);

Experiment rows_of(const std::string& word, const std::vector<std::string>& channels,
                   ReferenceDirection direction = ReferenceDirection::pull) {
  Experiment experiment;
  experiment.channels = channels;
  for (const double motor_N : {10.0, 20.0, 40.0}) {
    ExperimentRow row;
    row.condition.word = word;
    row.condition.direction = direction;
    row.condition.motor_tension_N = motor_N;
    row.condition.speed_mm_s = 5;
    row.measured = channels;
    experiment.rows.push_back(row);
  }
  return experiment;
}

std::vector<double> readings_of(const Truth& truth,
                                ReferenceDirection direction = ReferenceDirection::pull) {
  std::vector<double> column;
  for (const auto& row : expected_readings(truth, rows_of("M-1-F", {"T1"}, direction))) {
    column.push_back(row.at(0));
  }
  return column;
}

TEST(PlantedDrive, PullsMoreOrLessThanRecorded) {
  Truth truth;
  truth.drive = {0.9, 0.5, 2, 0.1};
  const auto pulled = readings_of(truth);
  const auto released = readings_of(truth, ReferenceDirection::release);
  for (std::size_t i = 0; i < 3; ++i) {
    const double motor_N = 10.0 * static_cast<double>(1 << i);
    EXPECT_NEAR(pulled[i], through * (0.9 * motor_N + 0.5 - 2 - 0.5), 1e-9);
    EXPECT_NEAR(released[i], (0.9 * motor_N + 0.5 + 2 + 0.5) / through, 1e-9);
  }
  truth.drive = {1, 0, 15, 0};
  EXPECT_EQ(readings_of(truth)[0], 0);
}

TEST(PlantedFriction, IsAnotherOneReleasing) {
  Truth truth;
  truth.nature.release_change = 0.5;
  EXPECT_NEAR(readings_of(truth)[0], 10 * through, 1e-9);
  EXPECT_NEAR(readings_of(truth, ReferenceDirection::release)[0], 10 / std::pow(through, 1.5),
              1e-8);
}

TEST(PlantedElectronics, EndDriftAndDie) {
  Truth truth;
  truth.electronics.limit_N["T1"] = 20 * through;
  truth.electronics.drift_N["T1"] = 3;
  const auto readings = readings_of(truth);
  EXPECT_NEAR(readings[0], 10 * through, 1e-9);
  EXPECT_NEAR(readings[1], 20 * through + 1.5, 1e-9);
  EXPECT_NEAR(readings[2], 20 * through + 3, 1e-9);
  truth.electronics.dead.insert("T1");
  for (const double reading : readings_of(truth)) EXPECT_EQ(reading, 0);
}

TEST(PlantedElectronics, HearTheirNeighboursAndAreExchanged) {
  const Experiment experiment = rows_of("M-1-F", {"a", "T1", "T2"});
  const auto clean = expected_readings({}, experiment);
  Truth truth;
  truth.electronics.part_of_neighbours["T1"] = 0.1;
  const auto heard = expected_readings(truth, experiment);
  Truth other;
  other.electronics.exchanged = {"a", "T2"};
  const auto exchanged = expected_readings(other, experiment);
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_NEAR(heard[row][1], clean[row][1] + 0.1 * (clean[row][0] + clean[row][2]), 1e-9);
    EXPECT_EQ(heard[row][0], clean[row][0]);
    EXPECT_EQ(exchanged[row][0], clean[row][2]);
    EXPECT_EQ(exchanged[row][2], clean[row][0]);
  }
}

}  // namespace
}  // namespace reeve::testing
