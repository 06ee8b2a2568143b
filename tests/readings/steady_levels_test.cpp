#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "readings/log/steady_readings.hpp"
#include "tests/support/rig_log.hpp"

namespace reeve::testing {
namespace {

std::size_t samples_with(const SteadyReadings& found, SampleUse use) {
  return static_cast<std::size_t>(std::count(found.uses.begin(), found.uses.end(), use));
}

// A load test in steps: no motion in the log.
LoggedSeries steps(const std::vector<double>& loads_N, double noise) {
  LoggedSeries series;
  series.file = "log.csv";
  series.motor_tension_N.name = "motor_tension_N";
  series.tensions_N = {{"T1_N", {}}};
  series.labels.emplace_back();
  const std::vector<double> scatter = correlated_noise(loads_N.size() * 300, 0.5, 3, 0);
  double level_N = loads_N.front();
  for (std::size_t i = 0; i < loads_N.size() * 300; ++i) {
    level_N += 0.05 * (loads_N[i / 300] - level_N);  // settles over a fifth of a second
    series.lines.push_back(i + 2);
    series.time_s.push_back(0.01 * static_cast<double>(i));
    series.label.push_back(0);
    series.motor_tension_N.values.push_back(level_N * (1 + noise * scatter[i]));
    series.tensions_N[0].values.push_back(0.5 * level_N * (1 - noise * scatter[i]));
  }
  return series;
}

TEST(SteadyLevels, OfALoadTestInStepsAreItsReadings) {
  const std::vector<double> loads_N{5, 10, 20, 30, 20, 10};
  const SteadyReadings found = steady_readings(steps(loads_N, 0.01), {});
  ASSERT_EQ(found.readings.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    const SteadyReading& reading = found.readings[i];
    const double error_N =
        reading.motor_tension_N->deviation_N / std::sqrt(static_cast<double>(reading.readings));
    EXPECT_NEAR(reading.motor_tension_N->mean_N, loads_N[i + 1],
                3 * error_N + 0.002 * loads_N[i + 1]);
    EXPECT_EQ(reading.direction, i < 3 ? Direction::pull : Direction::release);
  }
  ASSERT_EQ(found.notes.size(), 1U);
  EXPECT_EQ(found.notes[0].kind, NoteKind::no_motion);
  EXPECT_GT(samples_with(found, SampleUse::no_direction), 200U);
  EXPECT_GT(samples_with(found, SampleUse::load_varies), 100U);
}

TEST(SteadyLevels, OfAConstantSignalIsOneWithoutScatter) {
  SteadyOptions options;
  options.direction = Direction::pull;
  const SteadyReadings found = steady_readings(steps({20, 20, 20}, 0), options);
  ASSERT_EQ(found.readings.size(), 1U);
  EXPECT_EQ(found.readings[0].motor_tension_N->mean_N, 20);
  EXPECT_EQ(found.readings[0].motor_tension_N->deviation_N, 0);
}

TEST(SteadyLevels, AreNotFoundWhereTheLoadNeverRests) {
  LoggedSeries series = steps({20, 20, 20, 20}, 0.005);
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double swing = 1 + 0.5 * std::sin(6 * series.time_s[i]);
    series.motor_tension_N.values[i] *= swing;
    series.tensions_N[0].values[i] *= swing;
  }
  EXPECT_TRUE(steady_readings(series, {}).readings.empty());
}

TEST(SteadyLevels, AreNotFoundOnASlowRamp) {
  LoggedSeries series = steps({20, 20, 20, 20}, 0.002);
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double ramp = std::exp(0.05 * series.time_s[i]);
    series.motor_tension_N.values[i] *= ramp;
    series.tensions_N[0].values[i] *= ramp;
  }
  EXPECT_TRUE(steady_readings(series, {}).readings.empty());
}

// A set point that is logged as the speed says nothing of when the carriage moves.
TEST(SteadyLevels, AreSoughtWhereTheSpeedIsASetPoint) {
  LoggedSeries series = steps({5, 10, 20}, 0.01);
  series.speed_mm_s = {"speed_mm_s", std::vector<double>(series.size(), 10)};
  const SteadyReadings found = steady_readings(series, {});
  EXPECT_EQ(found.motion, MotionSource::none);
  ASSERT_EQ(found.readings.size(), 2U);
  EXPECT_EQ(found.readings[0].speed_mm_s, 10);
}

}  // namespace
}  // namespace reeve::testing
