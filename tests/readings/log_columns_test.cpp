// Headers of logs as people and loggers write them.
#include "readings/log/log_columns.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/readings/read_data.hpp"
#include "tests/readings/read_log.hpp"

namespace reeve::testing {
namespace {

using Values = std::vector<double>;

// A header's columns with the numbers of one row.
LoggedSeries sample(const std::string& header, const std::string& row) {
  return log_of(header + "\n" + row + "\n");
}

TEST(LogColumns, HaveThePositionInAnySpellingAndUnit) {
  for (const char* name : {"position_mm", "Position_mm", "POSITION [mm]", "pos_mm", "position"}) {
    EXPECT_EQ(sample(std::string("t,T1_N,T2_N,") + name, "0,1,2,30").position_mm.values, Values{30})
        << name;
  }
  EXPECT_EQ(sample("t,T1_N,T2_N,position_cm", "0,1,2,3").position_mm.values, Values{30});
  EXPECT_EQ(sample("t,T1_N,T2_N,Position (m)", "0,1,2,0.5").position_mm.values, Values{500});
}

TEST(LogColumns, HaveTheSpeedInAnySpellingAndUnit) {
  EXPECT_EQ(sample("t,T1_N,T2_N,Speed [mm/s]", "0,1,2,-30").speed_mm_s.values, Values{-30});
  EXPECT_EQ(sample("t,T1_N,T2_N,speed_cm_s", "0,1,2,-3").speed_mm_s.values, Values{-30});
}

TEST(LogColumns, HaveClocksAndTensionsAsFilesOfReadingsDo) {
  for (const char* name : {"Time [s]", "Time (s)", "TIME_S", "Time"}) {
    EXPECT_EQ(sample(std::string(name) + ",T1_N,T2_N", "7,1,2").time_s, Values{7}) << name;
  }
  EXPECT_EQ(sample("Time [ms],T1_N,T2_N", "7000,1,2").time_s, Values{7});
  const LoggedSeries series =
      sample("t,Motor Tension [N],T1 (N),t2,T3_kgf,Ta [lbf]", "0,9,1,2,3,4");
  EXPECT_EQ(series.motor_tension_N.values, Values{9});
  ASSERT_EQ(series.tensions_N.size(), 4U);
  EXPECT_EQ(series.tensions_N[0].name, "T1_N");
  EXPECT_EQ(series.tensions_N[1].values, Values{2});
  EXPECT_EQ(series.tensions_N[2].values, Values{3 * 9.80665});
  EXPECT_EQ(series.tensions_N[3].name, "Ta_N");
  EXPECT_EQ(series.tensions_N[3].values, Values{4 * 4.4482216152605});
}

TEST(LogColumns, SayHowTheyAreRead) {
  EXPECT_EQ(
      note_text(sample("Time,Position [cm],T1_N,T2", "0,1,2,3").notes, NoteKind::column_names),
      "columns are read so: 'Time' as time_s (no unit is said: s is assumed), 'Position [cm]' "
      "as position_mm (from cm), 'T2' as T2_N (no unit is said: N is assumed)");
  for (const char* clock : {"time_s", "t_s", "t_ms", "time_ms"}) {
    EXPECT_TRUE(sample(std::string(clock) + ",position_mm,T1_N,T2_N", "0,1,2,3").notes.empty())
        << clock;
  }
}

TEST(LogColumns, SayThatAClockWithoutAUnitIsReadInSeconds) {
  for (const std::string clock : {"t", "time", "timestamp"}) {
    EXPECT_EQ(note_text(sample(clock + ",T1_N,T2_N", "0,2,3").notes, NoteKind::column_names),
              "columns are read so: '" + clock + "' as time_s (no unit is said: s is assumed)");
    EXPECT_EQ(
        count_notes(log_of(clock + ",T1_N,T2_N\ns,N,N\n0,2,3\n").notes, NoteKind::column_names),
        0U);
  }
}

// A logger that counts milliseconds makes strokes of hours of them.
TEST(LogColumns, NoteAClockThatIsHardlyInSeconds) {
  ReadingOptions options;
  options.map_option = "--map";
  const auto doubt = [&](const std::string& clock, const std::string& start,
                         const std::string& next) {
    return note_text(
        parse_logged_series(clock + ",T1_N,T2_N\n" + start + ",1,2\n" + next + ",1,2\n", "log.csv",
                            options)
            .notes,
        NoteKind::clock);
  };
  EXPECT_EQ(doubt("t", "0", "10"),
            "the clock 't' has no unit: in seconds its samples are mostly 10 s apart. If it counts "
            "milliseconds, it is time_ms, and --map 't=time_ms' says so");
  EXPECT_EQ(doubt("timestamp", "1700000000000", "1700000000010"),
            "the clock 'timestamp' has no unit: in seconds its samples are mostly 10 s apart, and "
            "it shows the year 55841. If it counts milliseconds, it is time_ms, and --map "
            "'timestamp=time_ms' says so");
  EXPECT_EQ(doubt("t", "0", "0.01"), "");
  EXPECT_EQ(doubt("timestamp", "1700000000.00", "1700000000.01"), "");
  EXPECT_EQ(doubt("time_s", "0", "10"), "");
  // A clock of whole seconds, whose samples are spread between them.
  const std::string spread = doubt("t", "0,1,2\n0,1,2\n0", "1,1,2\n1,1,2\n1");
  EXPECT_EQ(spread.find("has no unit"), std::string::npos) << spread;
  options.map = {{"t", "time_ms"}};
  EXPECT_EQ(doubt("t", "0", "10"), "");
}

std::string doubt_of_speed(const std::string& clock, double step) {
  ReadingOptions options;
  options.unit_option = "--unit";
  const std::string text =
      fmt::format("{},T1_N,T2_N\n0,1,2\n{},1,2\n{},1,2\n", clock, step, 2 * step);
  return note_text(parse_logged_series(text, "log.csv", options).notes, NoteKind::clock);
}

TEST(LogColumns, HaveAClockInTheUnitThatItsNameSays) {
  const auto second = [](const std::string& clock, const char* cell) {
    return sample(clock + ",T1_N,T2_N", std::string(cell) + ",1,2").time_s;
  };
  EXPECT_EQ(second("t_us", "1500000"), Values{1.5});
  EXPECT_EQ(second("t_ns", "1500000000"), Values{1.5});
  EXPECT_EQ(second("time_ns", "1500000000"), Values{1.5});
  EXPECT_EQ(second("millis", "1500"), Values{1.5});
  EXPECT_EQ(second("micros", "1500000"), Values{1.5});
  EXPECT_EQ(second("elapsed_ms", "1500"), Values{1.5});
}

// Seconds in a column of milliseconds, and days.
TEST(LogColumns, NoteAClockThatIsTooFastForACarriage) {
  EXPECT_EQ(doubt_of_speed("t_ms", 0.01),
            "by the clock 't_ms', in ms, samples are mostly 1e-05 s apart and the log lasts 2e-05 "
            "s, which is fast for a carriage. If it counts seconds, it is time_s, and --unit "
            "'t_ms=s' says so");
  EXPECT_EQ(doubt_of_speed("time_s", 1e-7),
            "by the clock 'time_s', in s, samples are mostly 1e-07 s apart and the log lasts 2e-07 "
            "s, which is fast for a carriage. If it counts days, as spreadsheets do, multiply it "
            "by 86400, which makes seconds");
  EXPECT_EQ(doubt_of_speed("t_ms", 0.5), "");
  EXPECT_EQ(doubt_of_speed("time_s", 0.0005), "");
}

// Else readings would lack it, and nobody would know.
TEST(LogColumns, ThatWouldBeTensionsInAnotherUnitAreReported) {
  const std::string units = "(N, mN, cN, daN, kN, gf, kgf, lbf, ozf)";
  EXPECT_EQ(note_text(sample("t,T1_N,T2_N,T3 [V]", "0,1,2,3").notes, NoteKind::covariate),
            "column 'T3 [V]' has the name of a tension and no unit of force " + units +
                ": it is averaged as it is, and readings do not have it as T3_N");
  EXPECT_EQ(log_error("t,Motor Tension [Nm],T1_N,T2_N\n0,1,2,3\n"),
            "log.csv:1: column 2 'Motor Tension [Nm]': the unit Nm is no force: expected a unit of "
            "force " +
                units +
                ", or another name if it is no tension; a torque is no tension; divided by the "
                "spool's radius it would be motor_tension_N");
  const LoggedSeries both = sample("t,motor_tension_N,Motor Tension (V),T1_N", "0,1,2,3");
  EXPECT_EQ(both.motor_tension_N.values, Values{1});
  EXPECT_EQ(count_notes(both.notes, NoteKind::covariate), 1U);
  for (const char* name : {"T3 [°C]", "Ta [K]", "temperature [V]", "[V]", "U3 [V]"}) {
    EXPECT_EQ(count_notes(sample(std::string("t,T1_N,T2_N,") + name, "0,1,2,3").notes,
                          NoteKind::covariate),
              0U)
        << name;
  }
}

TEST(LogColumns, MayHaveARowOfUnits) {
  const LoggedSeries series =
      log_of("time;position;T1;T2;temperature\nms;cm;N;kgf;K\n10;2;3;1;300\n");
  EXPECT_EQ(series.time_s, Values{0.01});
  EXPECT_EQ(series.position_mm.values, Values{20});
  EXPECT_EQ(series.tensions_N[1].values, Values{9.80665});
  ASSERT_EQ(series.others.size(), 1U);
  EXPECT_EQ(series.others[0].name, "temperature_C");
  EXPECT_NEAR(series.others[0].values[0], 26.85, 1e-12);
  EXPECT_EQ(noted_lines(series.notes, NoteKind::passed_over), std::vector<std::size_t>{2});
}

TEST(LogColumns, MayHaveNoNameAndAreNotRead) {
  EXPECT_EQ(log_of("t;T1_N;T2_N;\n0;1;2;\n1;1;2\n").size(), 2U);
  const LoggedSeries series = log_of(",t,T1_N,T2_N\n1,0,1,2\n2,1,1,2\n");
  EXPECT_EQ(series.time_s, (Values{0, 1}));
  EXPECT_EQ(noted_lines(series.notes, NoteKind::passed_over), (std::vector<std::size_t>{2, 3}));
}

// Without a motion a log has other readings, and nobody would know.
TEST(LogColumns, ThatMayBeTheMotionAreReported) {
  EXPECT_EQ(log_error("t,Carriage position,T1_N,T2_N\n0,1,2,3\n"),
            "log.csv:1: column 2 'Carriage position': expected the carriage's position with a unit "
            "of length (mm, cm, m, µm, in), its speed with one of speed (mm/s, cm/s, m/s, mm/min, "
            "m/min, in/s), or another name if it is neither");
  for (const char* name : {"position_rev", "Speed [rpm]", "velocity_mm_s", "act. pos"}) {
    EXPECT_NE(log_error(std::string("t,T1_N,T2_N,") + name + "\n0,1,2,3\n").find("column 4 '"),
              std::string::npos)
        << name;
  }
  EXPECT_EQ(sample("t,position_mm,Speed [rpm],T1_N,T2_N", "0,1,2,3,4").others[0].name,
            "Speed [rpm]");
  EXPECT_EQ(note_text(sample("t,x_mm,T1_N,T2_N", "0,1,2,3").notes, NoteKind::covariate),
            "column 'x_mm' is in a unit of length or speed: it is not read as the carriage's "
            "position or speed, which are position_mm and speed_mm_s");
}

TEST(LogColumns, HaveTheClockThatSaysItsUnitWhereThereAreTwo) {
  const LoggedSeries series = sample("Timestamp,Time [s],T1_N,T2_N", "99,7,1,2");
  EXPECT_EQ(series.time_s, Values{7});
  ASSERT_EQ(series.others.size(), 1U);
  EXPECT_EQ(series.others[0].name, "Timestamp");
  EXPECT_EQ(sample("Time,time_s,T1_N,T2_N", "99,7,1,2").time_s, Values{7});
}

TEST(LogColumns, WithoutAClockAreNamedWithWhatSaysWhichIsOne) {
  ReadingOptions options;
  options.map_option = "--map";
  EXPECT_EQ(
      input_error([&] { parse_logged_series("Zeit [s],T1_N,T2_N\n0,1,2\n", "log.csv", options); }),
      "log.csv:1: the header has no column of time: expected one of time_s, t_s, t, time, "
      "timestamp (seconds), time_ms and t_ms; it has 'Zeit [s]', 'T1_N', 'T2_N'; name it "
      "with --map 'COLUMN=time_s'");
}

TEST(LogColumns, BelowALineOfOtherNamesAreFound) {
  EXPECT_EQ(log_error("Channel 1,Channel 2,Channel 3\ntime_s,T1_N,T2_N\n0,1,2\n"),
            "log.csv:1: no name in this line is one of a column, and line 2 has such names: "
            "expected the header first: take this line out, or begin it with #");
  EXPECT_EQ(log_of("#Channel 1,Channel 2,Channel 3\ntime_s,T1_N,T2_N\n0,1,2\n").size(), 1U);
}

TEST(LogColumns, OfOneMeaningAreRefused) {
  EXPECT_EQ(log_error("t,position_mm,Position [cm],T1_N,T2_N\n0,1,2,3,4\n"),
            "log.csv:1: column 3 'Position [cm]': expected one column of its meaning, and column 2 "
            "'position_mm' has it");
}

TEST(BadLog, HasAllItsFaultsListedAtOnce) {
  EXPECT_EQ(log_error("t,T1_N,T2_N,T0_N\n0,1,x,1\n,2,3,4\n2,1\n3,1e300,1,1\n"),
            "log.csv: 5 faults:\n"
            "  log.csv:1: column 4 'T0_N': expected a tension written as T1_N (strand), Ta_N "
            "(motor-side segment), Th1_N (stretch at the hand) or at_T1_N (the motor-side segment "
            "at T1)\n"
            "  log.csv:2: column 'T2_N' = 'x': expected a number from -1000000000 to 1000000000, "
            "or an empty cell\n"
            "  log.csv:3: column 't' = '': expected the time of the sample, a number\n"
            "  log.csv:4:4: 2 fields: expected 4, as many as the header in line "
            "1 has\n"
            "  log.csv:5: column 'T1_N' = '1e300': expected a number from -1000000000 to "
            "1000000000, or an empty cell");
}

}  // namespace
}  // namespace reeve::testing
