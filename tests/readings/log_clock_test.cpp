#include "readings/log/log_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/readings/read_data.hpp"
#include "tests/readings/read_log.hpp"
#include "tests/readings/rig_readings.hpp"

namespace reeve::testing {
namespace {

LoggedSeries log_at(const std::vector<std::string>& times) {
  std::string text = "t_s,T1_N,T2_N\n";
  for (const std::string& time : times) text += time + ",1,2\n";
  return log_of(text);
}

void expect_times(const LoggedSeries& series, const std::vector<double>& times) {
  ASSERT_EQ(series.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(series.time_s[i], times[i], 1e-12);
}

TEST(ACoarseClock, IsSpreadEvenlyBetweenItsSteps) {
  const LoggedSeries series = log_at({"0", "0", "4", "4", "8", "8", "8", "8", "12"});
  expect_times(series, {0, 2, 4, 6, 8, 9, 10, 11, 12});
  EXPECT_EQ(
      note_text(series.notes, NoteKind::clock),
      "5 of 9 samples show the time of the one before: the clock is coarser than the samples, "
      "which are spread evenly between its steps");
}

TEST(ACoarseClock, IsNotSpreadOverAGapNorWhereItIsSetBack) {
  expect_times(log_at({"0", "0", "2", "2", "4", "4", "90", "90", "92", "92", "0", "0", "2", "2"}),
               {0, 1, 2, 3, 4, 5, 90, 91, 92, 93, 0, 1, 2, 3});
}

TEST(AClock, ThatShowsATimeTwiceOnceStaysAsItIs) {
  std::vector<std::string> times;
  for (int i = 0; i < 50; ++i) times.push_back(std::to_string(i == 7 ? 6 : i));
  const LoggedSeries series = log_at(times);
  EXPECT_EQ(series.time_s[7], 6);
  EXPECT_TRUE(series.notes.empty());
}

std::size_t independent_readings(double clock_step_s) {
  RigPlan plan;
  plan.correlation = 0.6;
  std::vector<RigSample> samples = rig_log(plan, one_run);
  for (RigSample& sample : samples) {
    sample.time_s = clock_step_s * std::floor(sample.time_s / clock_step_s + 1e-6);
  }
  std::size_t sum = 0;
  for (const SteadyReading& reading : steady_readings(series_of(samples), {}).readings) {
    sum += reading.readings;
  }
  return sum;
}

// A growing load that jumps with the clock would pass for noise of one sample alone.
TEST(ACoarseClock, MakesReadingsWorthNoMore) {
  const auto fine = static_cast<double>(independent_readings(0.01));
  EXPECT_NEAR(static_cast<double>(independent_readings(0.05)), fine, 0.1 * fine);
  EXPECT_NEAR(static_cast<double>(independent_readings(0.02)), fine, 0.1 * fine);
}

}  // namespace
}  // namespace reeve::testing
