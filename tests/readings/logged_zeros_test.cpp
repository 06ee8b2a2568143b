// Rows of zeros in a log.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/readings/read_data.hpp"
#include "tests/readings/read_log.hpp"
#include "tests/readings/rig_readings.hpp"

namespace reeve::testing {
namespace {

using Values = std::vector<double>;

TEST(LoggedZeros, AreTakenOffTheSamplesBelowAndAreNone) {
  const LoggedSeries series = log_of(
      "t,run,position_mm,temperature_C,motor_tension_N,T1_N\n"
      "0,A,5,20,30,10\n"
      "1,tare,7,21,1,-2\n"
      ",Tare,7,21,3,\n"
      "3,A,5,20,30,10\n"
      "4,A,5,20,,10\n"
      "5,tare,7,21,-1,\n"
      "6,A,5,20,30,10\n");
  EXPECT_EQ(series.lines, (std::vector<std::size_t>{2, 5, 6, 8}));
  EXPECT_EQ(series.time_s, (Values{0, 3, 4, 6}));
  EXPECT_EQ(series.tensions_N[0].values, (Values{10, 12, 12, 12}));
  EXPECT_EQ(series.motor_tension_N.values[1], 28);
  EXPECT_EQ(series.motor_tension_N.values[3], 31);
  EXPECT_EQ(series.position_mm.values, (Values{5, 5, 5, 5}));
  EXPECT_EQ(noted_lines(series.notes, NoteKind::tare), (std::vector<std::size_t>{3, 4, 7}));
  for (const LogLabels& label : series.labels) EXPECT_EQ(label.run, "A");
}

// What a sensor read before and after is not of one stretch.
TEST(LoggedZeros, CutTheLog) {
  const LoggedSeries series = log_of(
      "t,routing,T1_N,T2_N\n0,TR1,1,2\n1,TR1,1,2\n2,tare,0.5,0.5\n3,TR1,1,2\n4,tare,0.6,0.5\n"
      "5,tare,0.6,0.5\n6,TR1,1,2\n");
  const Recordings found = recordings(series);
  ASSERT_EQ(found.parts.size(), 3U);
  EXPECT_EQ(found.parts[1].begin, 2U);
  EXPECT_EQ(found.parts[2].begin, 3U);
}

TEST(LoggedZeros, MayBeAllThatALogHas) {
  EXPECT_EQ(log_error("t,run,T1_N,T2_N\n0,tare,1,2\n"),
            "log.csv:1: expected readings below the header, and there are rows of zeros (tare) "
            "alone");
}

// A zero that is off would keep the ratios from settling.
TEST(LoggedZeros, LeaveTheReadingsThatTheLogWouldHaveWithoutThem) {
  const std::vector<RigSample> samples = rig_log({}, one_run);
  std::string text = "time_s,run,position_mm,motor_tension_N,T1_N,T2_N,T3_N,T4_N\n";
  for (int i = 0; i < 20; ++i) text += fmt::format("{},tare,0,0.1,0.7,0.1,0.1,-3\n", -1 + 0.01 * i);
  for (const RigSample& sample : samples) {
    const std::vector<double>& read_N = sample.strands_read_N;
    text += fmt::format("{},A,{},{},{},{},{},{}\n", sample.time_s, sample.position_mm,
                        sample.motor_read_N + 0.1, read_N[0] + 0.7, read_N[1] + 0.1,
                        read_N[2] + 0.1, read_N[3] - 3);
  }
  const SteadyReadings found = steady_readings(log_of(text), {});
  EXPECT_EQ(found.readings.size(), 40U);
  EXPECT_GT(share_within(deviations_from_truth(samples, found), 3), 0.97);
}

}  // namespace
}  // namespace reeve::testing
