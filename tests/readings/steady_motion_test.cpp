// How the carriage moves, by what the log has of it.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/readings/rig_readings.hpp"

namespace reeve::testing {
namespace {

TEST(SteadyReadings, GoByASignedSpeedWhereThereIsNoPosition) {
  const std::vector<RigSample> samples = rig_log({}, one_run);
  const SteadyReadings found =
      steady_readings(series_of(samples, {.position = false, .speed = true, .labels = false}), {});
  EXPECT_EQ(found.motion, MotionSource::speed);
  EXPECT_EQ(found.readings.size(), 40U);
  expect_sound(samples, found);
}

TEST(SteadyReadings, GoByTheLoadWhereTheSpeedHasNoSign) {
  const std::vector<RigSample> samples = rig_log({}, one_run);
  LoggedSeries series = series_of(samples, {.position = false, .speed = true, .labels = false});
  for (double& speed : series.speed_mm_s.values) speed = std::abs(speed);
  const SteadyReadings found = steady_readings(series, {});
  EXPECT_EQ(found.readings.size(), 40U);
  expect_sound(samples, found);
}

TEST(SteadyReadings, OfAnEvenLoadNeedToBeToldTheDirectionWhereTheSpeedHasNoSign) {
  RigPlan plan;
  plan.greatest_load_N = plan.least_load_N = 20;
  LoggedSeries series =
      series_of(rig_log(plan, one_run), {.position = false, .speed = true, .labels = false});
  for (double& speed : series.speed_mm_s.values) speed = std::abs(speed);
  const SteadyReadings silent = steady_readings(series, {});
  EXPECT_TRUE(silent.readings.empty());
  EXPECT_GT(count(silent, SampleUse::no_direction), 1500U);
  ASSERT_EQ(silent.notes.size(), 1U);
  EXPECT_EQ(silent.notes[0].kind, NoteKind::no_direction);
  SteadyOptions options;
  options.direction = Direction::release;
  const SteadyReadings told = steady_readings(series, options);
  ASSERT_EQ(told.readings.size(), 8U);
  EXPECT_TRUE(told.notes.empty());
  EXPECT_EQ(told.readings[0].direction, Direction::release);
}

TEST(SteadyReadings, NoteAPositionThatCountsTheOtherWayAndTurnIt) {
  LoggedSeries series = series_of(rig_log({}, one_run));
  for (double& position : series.position_mm.values) position = -position;
  const SteadyReadings wrong = steady_readings(series, {});
  ASSERT_EQ(wrong.notes.size(), 1U);
  EXPECT_EQ(wrong.notes[0].kind, NoteKind::reversed);
  SteadyOptions options;
  options.reverse = true;
  const SteadyReadings right = steady_readings(series, options);
  EXPECT_TRUE(right.notes.empty());
  EXPECT_EQ(right.readings[0].direction, Direction::pull);
}

// Without friction neither direction has more motor tension, whatever the noise does to medians.
TEST(SteadyReadings, SayNothingOfAReversedPositionWhereThereIsNoiseAlone) {
  const std::vector<RigRun> smooth{{"1", "TR1", "", {{1, 1}, {1, 1}, {1, 1}, {1, 1}}}};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RigPlan plan;
    plan.seed = seed;
    plan.least_load_N = plan.greatest_load_N = 14;
    plan.strokes = 6;
    EXPECT_TRUE(readings_on(plan, smooth).found.notes.empty()) << seed;
    plan.greatest_load_N = 30;
    EXPECT_TRUE(readings_on(plan, smooth).found.notes.empty()) << seed;
  }
}

TEST(SteadyReadings, TakeTheDirectionThatTheLogNames) {
  LoggedSeries series = series_of(rig_log({}, one_run));
  series.labels[0].direction = "Release";
  for (const SteadyReading& reading : steady_readings(series, {}).readings) {
    EXPECT_EQ(reading.direction, Direction::release);
  }
}

TEST(SteadyReadings, DoNotComeFromAPositionThatIsNothingButNoise) {
  std::vector<RigSample> samples = rig_log({}, one_run);
  LoggedSeries series = series_of(samples);
  series.position_mm.values = correlated_noise(series.size(), 0.9, 2, 9);
  const SteadyReadings found = steady_readings(series, {});
  EXPECT_TRUE(found.readings.empty());
  EXPECT_GT(count(found, SampleUse::standstill), 9 * series.size() / 10);
}

}  // namespace
}  // namespace reeve::testing
