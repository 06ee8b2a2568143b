// What is taken from logs with spikes, holes, copies and gaps.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "tests/readings/rig_readings.hpp"

namespace reeve::testing {
namespace {

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
