#include "diagnosis/plan/next_measurement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "causes/library.hpp"
#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {
namespace {

// One load, one speed.
const std::string few_conditions =
    "run,routing,motor_tension_N,speed_mm_s,T1_N,T2_N\n"
    "1,M-1-F,20,30,6,3\n2,M-1-F,20,30,6.1,3.1\n3,M-1-F,20,30,6.05,3.05\n";

Model with(const char* cause, std::vector<double> values, Subject subject = {}) {
  Model model;
  add_effect(model, {find_cause(cause), std::move(subject), std::move(values)});
  return model;
}

MeasurementPlan plan(const MeasuredData& data) {
  return {&data,
          {{"M-1-F", parse_routing("M-1-F")}, {"M-1-T-2-F", parse_routing("M-1-T-2-F")}},
          Noise{0.02, 0.05, diagnosis::NoiseSource::repeats, 30}};
}

// At 30 mm/s both make the exponents of tubes and sheaths the same multiple.
TEST(SeparatingMeasurement, OfSpeedAndFrictionAsksForAnotherSpeed) {
  const MeasuredData data = read_data(few_conditions);
  const double slope = 0.1;
  const double factor = 1 + slope * std::log(3);
  Model friction = with("tube_friction", {0.18 * factor});
  add_effect(friction, {find_cause("sheath_friction"), {}, {0.18 * factor}});
  const auto measurement = separating_measurement(
      plan(data), {with("speed_dependent_friction", {slope}), friction}, {"a", "b"});
  ASSERT_TRUE(measurement.has_value());
  EXPECT_NE(measurement->measurement.conditions.speed_mm_s, 30);
  EXPECT_TRUE(measurement->measurement.uses_speed);
  EXPECT_EQ(measurement->between, (std::vector<std::string>{"a", "b"}));
  EXPECT_GT(measurement->expected_log_likelihood, 1);
}

TEST(SeparatingMeasurement, OfGainAndOffsetAsksForAnotherLoad) {
  const MeasuredData data = read_data(few_conditions);
  Subject t1;
  t1.channel = parse_segment("T1");
  const double read = 20 * std::exp(-0.36 * std::numbers::pi);
  const auto measurement = separating_measurement(
      plan(data), {with("sensor_gain", {1.1}, t1), with("sensor_offset", {0.1 * read}, t1)},
      {"gain", "offset"});
  ASSERT_TRUE(measurement.has_value());
  EXPECT_GT(std::abs(measurement->measurement.conditions.motor_tension_N - 20), 1);
}

TEST(SeparatingMeasurement, DoesNotExistBetweenEqualModels) {
  const MeasuredData data = read_data(few_conditions);
  const Model model = with("tube_friction", {0.1});
  EXPECT_FALSE(separating_measurement(plan(data), {model, model}, {"a", "b"}).has_value());
}

// Releasing, T4 of M-1-T-2-F is 17 times the motor tension: there the two differ most.
TEST(SeparatingMeasurement, AsksForNoReadingFarBeyondWhatTheRigHasShown) {
  const MeasuredData data = read_data(few_conditions);
  const auto measurement = separating_measurement(
      plan(data), {with("tube_friction", {0.18}), with("tube_friction", {0.15})}, {"a", "b"});
  ASSERT_TRUE(measurement.has_value());
  ASSERT_FALSE(measurement->expected.empty());
  const double load = measurement->measurement.conditions.motor_tension_N;
  for (const ExpectedReading& reading : measurement->expected) {
    EXPECT_LE(std::max(reading.expected_N, reading.other_N), 3 * std::max(6.1, load));
  }
}

TEST(ShrinkingMeasurement, IsExpectedToNarrowWhatItSaysItNarrows) {
  const MeasuredData data = read_data(few_conditions);
  const Dataset dataset = all_of(data);
  const Problem problem = reeve::problem(dataset, Eigen::VectorXd::Constant(6, 0.1));
  const auto measurement =
      shrinking_measurement(plan(data), problem, with("tube_friction", {0.15}), 0);
  ASSERT_TRUE(measurement.has_value());
  EXPECT_EQ(measurement->parameter, "mu");
  EXPECT_LT(measurement->width_expected, measurement->width_now);
  EXPECT_GT(measurement->width_expected, 0);
}

// Of ten mountings with an exponent of their own each, another adds an eleventh, however well it
// is read: the interval narrows by the root of 10/11.
TEST(ShrinkingMeasurement, CountsANewMountingAsOne) {
  const MeasuredData data = read_data(few_conditions);
  const Dataset dataset = all_of(data);
  const Model model = with("tube_friction", {0.15});
  MeasurementPlan mounted{&data, {{"M-1-F", parse_routing("M-1-F")}}, {0, 1e-4}};
  const double scatter = 0.02;
  mounted.mounting[static_cast<std::size_t>(Mounted::tube)] = scatter;
  // A reading of the ratio T2/T1 alone: ten mountings' information on mu is 10 / (scatter mu)².
  Problem problem = reeve::problem(dataset, Eigen::VectorXd::Constant(6, 1));
  const Eigen::MatrixXd unit = sensitivities(problem, model, forecast(dataset, model));
  problem.deviation_N *= unit.norm() * scatter * 0.15 / std::sqrt(10);
  const auto measurement = shrinking_measurement(mounted, problem, model, 0);
  ASSERT_TRUE(measurement.has_value());
  EXPECT_NEAR(measurement->width_expected / measurement->width_now, std::sqrt(10.0 / 11), 1e-4);
}

// The more a new mounting scatters, the less its readings tell one explanation from another.
TEST(SeparatingMeasurement, IsNoBetterThanTheMountingItTakes) {
  const MeasuredData data = read_data(few_conditions);
  MeasurementPlan mounted = plan(data);
  mounted.noise = {0, 1e-4};
  mounted.routings.resize(1);
  const double scatter = 0.1;
  mounted.mounting[static_cast<std::size_t>(Mounted::tube)] = scatter;
  const auto measurement = separating_measurement(
      mounted, {with("tube_friction", {0.18}), with("tube_friction", {0.17})}, {"a", "b"});
  EXPECT_FALSE(measurement.has_value());  // (0.01 / 0.018)² / 2 nats
}

}  // namespace
}  // namespace reeve::testing
