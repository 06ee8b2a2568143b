// What is steady in the strokes of a rig.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/readings/rig_readings.hpp"

namespace reeve::testing {
namespace {

TEST(SteadyReadings, AreTakenFromEveryStrokeAndNeverWhereAContactSticks) {
  for (const double correlation : {0.0, 0.9}) {
    RigPlan plan;
    plan.correlation = correlation;
    const auto [samples, found] = readings_on(plan);
    EXPECT_EQ(found.motion, MotionSource::position);
    EXPECT_EQ(found.readings.size(), 40U);
    expect_sound(samples, found);
    EXPECT_GT(count(found, SampleUse::taken), 2500U);
    EXPECT_GT(count(found, SampleUse::settling), 200U);
    EXPECT_GT(count(found, SampleUse::standstill), 600U);
    EXPECT_LT(count(found, SampleUse::spike), 5U);  // nor a rest of sticking
  }
}

TEST(SteadyReadings, HaveMeansWithinTheirStandardErrors) {
  RigPlan plan;
  plan.strokes = 8;
  plan.correlation = 0.7;
  const auto [samples, found] = readings_on(plan);
  const std::vector<double> deviations = deviations_from_truth(samples, found);
  ASSERT_EQ(deviations.size(), 320U);
  EXPECT_NEAR(share_within(deviations, 1.96), 0.95, 0.035);
  EXPECT_NEAR(share_within(deviations, 0.674), 0.5, 0.09);
}

TEST(SteadyReadings, OfAnEvenLoadAreOneForEachStroke) {
  RigPlan plan;
  plan.greatest_load_N = plan.least_load_N = 20;
  const auto [samples, found] = readings_on(plan);
  EXPECT_EQ(found.readings.size(), 8U);
  expect_sound(samples, found);
}

TEST(SteadyReadings, OfASweepStandForLoadsOfTheirOwn) {
  const std::vector<RigSample> samples = rig_log({}, one_run);
  SteadyOptions options;
  options.readings_per_stroke = 3;
  const SteadyReadings found = steady_readings(series_of(samples), options);
  ASSERT_EQ(found.readings.size(), 24U);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_GT(found.readings[i].motor_tension_N->mean_N,
              1.1 * found.readings[i - 1].motor_tension_N->mean_N);
  }
}

// A long take-up: half of each stroke only brings the contacts to slide.
TEST(SteadyReadings, LeaveOutALongTakeUp) {
  RigPlan plan;
  plan.stiffness_N_mm = 2.5;
  const auto [samples, found] = readings_on(plan);
  EXPECT_GE(found.readings.size(), 16U);
  EXPECT_GT(count(found, SampleUse::settling), 800U);
  expect_sound(samples, found);
}

// So slowly that each block looks as if it went on as the next.
TEST(SteadyReadings, LeaveOutASlowTakeUp) {
  RigPlan plan;
  plan.rate_hz = 50;
  plan.strokes = 1;
  plan.speed_mm_s = 0.2;
  plan.even_s = 60;
  plan.stiffness_N_mm = 2.5;
  plan.noise = plan.noise_N = 0.002;
  const auto [samples, found] = readings_on(plan);
  EXPECT_GE(found.readings.size(), 5U);
  expect_sound(samples, found);
}

// Little friction, which two fifths of each stroke take up: a bend in two lines that are nearly
// one.
TEST(SteadyReadings, LeaveOutASlightTakeUpHoweverSlowTheCarriageIs) {
  const std::vector<RigRun> smooth{
      {"1", "TR1", "", {{0.73, 0.93}, {0.72, 0.92}, {0.71, 0.91}, {0.7, 0.9}}}};
  for (const double slower : {1.0, 10.0}) {
    RigPlan plan;
    plan.strokes = 2;
    plan.even_s = 4 * slower;
    plan.speed_mm_s = 10 / slower;
    plan.stiffness_N_mm = 0.4;
    plan.greatest_load_N = plan.least_load_N = 20;
    plan.noise = plan.noise_N = 0.001;
    const auto [samples, found] = readings_on(plan, smooth);
    EXPECT_EQ(found.readings.size(), 4U);
    expect_sound(samples, found);
  }
}

TEST(SteadyReadings, DoNotComeFromStrokesTooShortForTheContactsToSlide) {
  RigPlan plan;
  plan.even_s = 1.5;
  plan.stiffness_N_mm = 0.5;
  plan.greatest_load_N = plan.least_load_N = 30;
  const auto [samples, found] = readings_on(plan);
  EXPECT_GT(count(found, SampleUse::not_following), 800U);
  EXPECT_TRUE(found.readings.empty());
}

TEST(SteadyReadings, OfASlowLoggerAreTheSame) {
  RigPlan plan;
  plan.rate_hz = 10;
  plan.even_s = 20;
  plan.speed_mm_s = 2;
  const auto [samples, found] = readings_on(plan);
  EXPECT_EQ(found.readings.size(), 40U);
  expect_sound(samples, found);
}

TEST(SteadyReadings, DoNotComeFromARigThatStands) {
  RigPlan plan;
  plan.strokes = 1;
  plan.dwell_s = 30;
  std::vector<RigSample> samples = rig_log(plan, one_run);
  samples.resize(3000);
  const SteadyReadings found = steady_readings(series_of(samples), {});
  EXPECT_TRUE(found.readings.empty());
  EXPECT_EQ(count(found, SampleUse::standstill), 3000U);
}

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

TEST(SteadyReadings, DoNotFollowSpikes) {
  const std::vector<RigSample> samples = rig_log({}, one_run);
  LoggedSeries series = series_of(samples);
  for (std::size_t i = 50; i < series.size(); i += 97) series.tensions_N[i % 4].values[i] = 1e9;
  for (std::size_t i = 20; i < series.size(); i += 89) series.position_mm.values[i] = -1e6;
  const SteadyReadings found = steady_readings(series, {});
  EXPECT_EQ(found.readings.size(), 40U);
  EXPECT_GT(count(found, SampleUse::spike), 15U);
  EXPECT_GT(share_within(deviations_from_truth(samples, found), 3), 0.97);
}

// Not that contacts do not slide yet.
TEST(SteadyReadings, NameASensorAtTheEndOfItsRange) {
  LoggedSeries series = series_of(rig_log({}, one_run));
  for (double& tension : series.tensions_N[2].values) tension = std::min(tension, 5.5);
  const SteadyReadings found = steady_readings(series, {});
  EXPECT_GT(count(found, SampleUse::not_following), 1000U);
  ASSERT_EQ(found.notes.size(), 1U);
  EXPECT_EQ(found.notes[0].kind, NoteKind::not_following);
  EXPECT_EQ(found.notes[0].text.substr(0, 10), "T3_N stays");
  EXPECT_GE(found.notes[0].lines.size(), 4U);
}

TEST(SteadyReadings, LeaveOutSamplesThatLackAValue) {
  const std::vector<RigSample> samples = rig_log({}, one_run);
  LoggedSeries series = series_of(samples);
  for (std::size_t i = 0; i < series.size(); i += 10) {
    series.tensions_N[1].values[i] = std::numeric_limits<double>::quiet_NaN();
  }
  const SteadyReadings found = steady_readings(series, {});
  EXPECT_EQ(found.readings.size(), 40U);
  EXPECT_GT(count(found, SampleUse::incomplete), 250U);
  expect_sound(samples, found);
}

TEST(SteadyReadings, HaveNoTensionOfASensorThatIsOff) {
  LoggedSeries series = series_of(rig_log({}, one_run));
  for (double& tension : series.tensions_N[2].values) {
    tension = std::numeric_limits<double>::quiet_NaN();
  }
  const SteadyReadings found = steady_readings(series, {});
  ASSERT_EQ(found.readings.size(), 40U);
  EXPECT_FALSE(found.readings[7].tensions_N[2]);
  EXPECT_TRUE(found.readings[7].tensions_N[3]);
  EXPECT_EQ(count(found, SampleUse::incomplete), 0U);
}

// A logger that writes four rows for each that it measures.
TEST(SteadyReadings, CountCopiesOnce) {
  RigPlan plan;
  const std::vector<RigSample> samples = rig_log(plan, one_run);
  const SteadyReadings plain = steady_readings(series_of(samples), {});
  std::vector<RigSample> copied;
  for (const RigSample& sample : samples) {
    for (int i = 0; i < 4; ++i) {
      copied.push_back(sample);
      copied.back().time_s += i * 0.0025;
    }
  }
  const SteadyReadings found = steady_readings(series_of(copied), {});
  EXPECT_EQ(found.readings.size(), 40U);
  EXPECT_GT(count(found, SampleUse::copy), 2 * count(found, SampleUse::taken));
  std::size_t worth = 0;
  std::size_t worth_before = 0;
  for (const SteadyReading& reading : found.readings) worth += reading.readings;
  for (const SteadyReading& reading : plain.readings) worth_before += reading.readings;
  EXPECT_NEAR(static_cast<double>(worth) / static_cast<double>(worth_before), 1, 0.1);
}

TEST(SteadyReadings, DoNotReachOverAGapOrAClockThatIsSetBack) {
  std::vector<RigSample> samples = rig_log({}, one_run);
  samples.erase(samples.begin() + 270, samples.begin() + 350);
  for (std::size_t i = 2000; i < samples.size(); ++i) samples[i].time_s -= 15;
  const SteadyReadings found = steady_readings(series_of(samples), {});
  for (const SteadyReading& reading : found.readings) {
    EXPECT_FALSE(reading.begin < 270 && reading.end > 270);
    EXPECT_FALSE(reading.begin < 2000 && reading.end > 2000);
  }
  ASSERT_EQ(found.notes.size(), 1U);
  EXPECT_EQ(found.notes[0].kind, NoteKind::clock);
  EXPECT_EQ(found.notes[0].lines, std::vector<std::size_t>{2002});
  expect_sound(samples, found);
}

TEST(SteadyReadings, DoNotComeFromASingleSample) {
  std::vector<RigSample> samples = rig_log({}, one_run);
  samples.resize(1);
  const SteadyReadings found = steady_readings(series_of(samples), {});
  EXPECT_TRUE(found.readings.empty());
  EXPECT_EQ(found.uses.size(), 1U);
}

}  // namespace
}  // namespace reeve::testing
