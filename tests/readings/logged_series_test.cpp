#include "readings/log/logged_series.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "tests/readings/read_data.hpp"
#include "tests/readings/read_log.hpp"
#include "tests/readings/rig_readings.hpp"

namespace reeve::testing {
namespace {

// By log; a message that ends with … is told as far as that.
void expect_refused(const std::map<std::string, std::string>& messages) {
  for (const auto& [text, expected] : messages) {
    const std::string message = log_error(text);
    const std::size_t told = expected.ends_with("…") ? expected.rfind("…") : std::string::npos;
    EXPECT_EQ(message.substr(0, told), expected.substr(0, told)) << text;
  }
}

TEST(LoggedSeries, HasEachColumnInItsPlace) {
  const LoggedSeries series = log_of(
      "# our rig, May 3\ntime_ms,run,position_mm,motor_tension_N,T1_N,Ta_N,temperature_C,operator\n"
      "10,A,1,20,6,9,21,Kim\n20,A,2,21,7,9,22,Kim\n30,B,3,22,8,9,23,Kim\n");
  EXPECT_EQ(series.time_s, (std::vector<double>{0.01, 0.02, 0.03}));
  EXPECT_EQ(series.position_mm.values, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(series.motor_tension_N.values, (std::vector<double>{20, 21, 22}));
  ASSERT_EQ(series.tensions_N.size(), 2U);
  EXPECT_EQ(series.tensions_N[1].name, "Ta_N");
  ASSERT_EQ(series.others.size(), 1U);
  EXPECT_EQ(series.others[0].values, (std::vector<double>{21, 22, 23}));
  ASSERT_EQ(series.notes.size(), 1U);
  EXPECT_EQ(series.notes[0].text,
            "column 'operator' holds text: the log is cut where it changes, and readings do not "
            "have it");
  EXPECT_EQ(series.label, (std::vector<std::size_t>{0, 0, 1}));
  EXPECT_EQ(series.labels[1].run, "B");
  EXPECT_EQ(series.lines, (std::vector<std::size_t>{3, 4, 5}));
  EXPECT_EQ(series.comments, std::vector<std::string>{" our rig, May 3"});
  EXPECT_FALSE(series.simulated);
}

TEST(LoggedSeries, TakesWhatFilesOfReadingsDoAsMissing) {
  const LoggedSeries series = log_of("t,T1_N,T2_N\n0,,2\n1,NaN,-0.1\n2,-,\n3,3,n/a\n");
  EXPECT_TRUE(std::isnan(series.tensions_N[0].values[0]));
  EXPECT_TRUE(std::isnan(series.tensions_N[0].values[1]));
  EXPECT_TRUE(std::isnan(series.tensions_N[0].values[2]));
  EXPECT_EQ(series.tensions_N[0].values[3], 3);
  EXPECT_EQ(series.tensions_N[1].values[1], -0.1);
  EXPECT_TRUE(std::isnan(series.tensions_N[1].values[3]));
}

TEST(LoggedSeries, IsSimulatedIfACommentSaysSo) {
  EXPECT_TRUE(log_of("# Simulated rig\nt,T1_N,T2_N\n0,1,2\n").simulated);
}

std::string clock_on_the_wall(int sample, int samples_per_second) {
  return fmt::format("12:00:{:02}", sample / samples_per_second);
}

// Else no reading would be longer than a sample, or a second.
TEST(TextThatGoesWithTheSamples, DoesNotCutTheLog) {
  std::string text = "date,wall,coarse,state,phase,t,T1_N,T2_N\n";
  for (int i = 0; i < 40; ++i) {
    text += fmt::format("2024-05-01,12:00:00.{:02},{},{},{},{},1,2\n", i, clock_on_the_wall(i, 10),
                        i % 2 == 0 ? "a" : "b", i < 20 ? "out" : "back", i);
  }
  const LoggedSeries series = log_of(text);
  EXPECT_EQ(series.labels.size(), 2U);
  EXPECT_EQ(recordings(series).parts.size(), 2U);
  std::vector<std::string> passed_over;
  for (const DataNote& note : series.notes) {
    if (note.kind == NoteKind::passed_over) passed_over.push_back(note.text);
  }
  ASSERT_EQ(passed_over.size(), 3U);
  EXPECT_EQ(passed_over[1],
            "column 'coarse' holds times of day, or text that changes every few samples: it is not "
            "read");
}

TEST(RowsOfALogThatAreNotNumbers, AreLeftOutIfTheyAreFew) {
  const auto log = [](std::size_t rows, const std::string& garbled) {
    std::string text = "t_ms,T1_N,T2_N,note\n";
    for (std::size_t i = 0; i < rows; ++i) text += fmt::format("{},1,2,ok\n", 10 * i);
    return text + garbled + "9999,1,2,ok\n";
  };
  for (const char* garbled : {"Calibrating... done\n", "10,1.5\n", "10,1.2.3,2,ok\n", "10,x,2,ok\n",
                              "10,1,2,3,4,5,6\n"}) {
    const LoggedSeries series = log_of(log(60, garbled));
    EXPECT_EQ(series.size(), 61U) << garbled;
    EXPECT_EQ(noted_lines(series.notes, NoteKind::passed_over), std::vector<std::size_t>{62})
        << garbled;
    EXPECT_NE(log_error(log(40, garbled)), "no such error was thrown") << garbled;
  }
}

TEST(BadLog, IsNamedWithWhatItsHeaderLacks) {
  expect_refused({
      {"T1_N,T2_N\n1,2\n",
       "log.csv:1: the header has no column of time: expected one of time_s, t_s, t, time, "
       "timestamp (seconds), time_ms and t_ms"},
      {"t,time_s,T1_N,T2_N\n0,0,1,2\n",
       "log.csv:1: the header has more than one column of time: …"},
      {"t,force\n0,1\n", "log.csv:1: the header has no column of tensions: expected …"},
      {"t,T1_N\n0,1\n", "log.csv:1: the header has one column of tensions: expected …"},
      {"t,T1_N,T1_N\n0,1,1\n", "log.csv:1: column 3 'T1_N': column 2 has that name already"},
      {"t,T1_N,T0_N\n0,1,1\n", "log.csv:1: column 3 'T0_N': expected a tension written as …"},
      {"t,T1_N,T2_N,readings\n0,1,1,1\n",
       "log.csv:1: column 4 'readings': expected another name: …"},
      {"t,T1_N,T2_N\n", "log.csv:1: expected rows below the header, and there are none"},
      {"", "log.csv: is empty: expected a header and rows below it"},
  });
}

TEST(BadLog, IsNamedWithLineColumnAndWhatWasExpected) {
  expect_refused({
      {"t,T1_N,T2_N\n0,1,2\n1,x,2\n",
       "log.csv:3: column 'T1_N' = 'x': expected a number from -1000000000 to 1000000000, or an "
       "empty cell"},
      {"t,T1_N,T2_N\n0,1,2\n1,1e300,2\n", "log.csv:3: column 'T1_N' = '1e300': …"},
      {"t,T1_N,T2_N\n,1,2\n",
       "log.csv:2: column 't' = '': expected the time of the sample, a number"},
      {"t,T1_N,T2_N\n0,1,2\nx,1,2\n",
       "log.csv:3: column 't' = 'x': expected the time of the sample: a number, or a time of day "
       "with seconds, such as 9:59:58.25 or 2026-11-30 09:59:58.25"},
      {"t,T1_N,T2_N\n2024-03-01,1,2\n",
       "log.csv:2: column 't' = '2024-03-01': expected the time …"},
      {"t,T1_N,T2_N\n12:01,1,2\n", "log.csv:2: column 't' = '12:01': expected the time …"},
      {"t,T1_N,T2_N\n0,1,2\n12:00:01,1,2\n",
       "log.csv:3: column 't' = '12:00:01': expected a number, as in the samples before"},
      {"t,T1_N,T2_N\n12:00:01,1,2\n3,1,2\n",
       "log.csv:3: column 't' = '3': expected a time of day, as in the samples before"},
      {"t,T1_N,T2_N,c\n0,1,2,3\n1,1,2,x\n", "log.csv:3: column 'c' = 'x': …"},
  });
}

// Expected are the seconds since the beginning of the first day, counted by hand.
TEST(LoggedSeries, HasTimesOfDayInSeconds) {
  const auto times = [](const std::vector<std::string>& clock) {
    std::string log = "time,T1_N,T2_N\n";
    for (const std::string& time : clock) log += '"' + time + "\",1,2\n";
    return parse_logged_series(log, "log.csv").time_s;
  };
  using Times = std::vector<double>;
  EXPECT_EQ(times({"9:59:58", "09:59:59.25", "10:00:00,5"}), (Times{35998, 35999.25, 36000.5}));
  EXPECT_EQ(times({"09:59:58:250", "09:59:58:500"}), (Times{35998.25, 35998.5}));
  EXPECT_EQ(times({"23:59:59.5", "00:00:01"}), (Times{86399.5, 86401}));
  EXPECT_EQ(times({"59:59.5", "00:01.5"}), (Times{3599.5, 3601.5}));
  EXPECT_EQ(times({"2026-11-30T23:59:59Z", "2026-12-01T00:00:01Z"}), (Times{86399, 86401}));
  EXPECT_EQ(times({"2026-11-30 09:00:00+01:00", "2026-12-01 10:00:00+01:00"}),
            (Times{32400, 122400}));
  EXPECT_EQ(times({"30.11.2026 12:00:00", "30.11.2026 11:00:00"}), (Times{43200, 39600}));
  EXPECT_EQ(times({"11/30/2026 11:59:59 AM", "11/30/2026 12:00:01 PM", "12/1/2026 12:00:00 am"}),
            (Times{43199, 43201, 86400}));
}

TEST(Recordings, EndWhereTheClockIsSetBackOrALabelChanges) {
  std::string text = "t,run,T1_N,T2_N\n";
  for (int i = 0; i < 60; ++i) {
    text += std::to_string(i % 40) + (i < 20 ? ",A" : ",B") + ",1,2\n";
  }
  const Recordings found = recordings(log_of(text));
  ASSERT_EQ(found.parts.size(), 3U);
  EXPECT_EQ(found.parts[1].begin, 20U);
  EXPECT_EQ(found.parts[1].label, 1U);
  EXPECT_EQ(found.parts[2].begin, 40U);
  EXPECT_EQ(found.parts[2].end, 60U);
  EXPECT_EQ(found.clock_set_back, std::vector<std::size_t>{42});
}

TEST(Recordings, NeedAClockThatRunsForward) {
  std::string text = "t,T1_N,T2_N\n";
  for (int i = 40; i > 0; --i) text += std::to_string(i) + ",1,2\n";
  EXPECT_EQ(log_error(text),
            "log.csv:3: the time is less than in the row before, and so in 39 of 40 rows: expected "
            "rows in the order of their time");
}

using Values = std::vector<double>;

TEST(LoggedZeros, AreSubtractedFromTheSamplesBelow) {
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
