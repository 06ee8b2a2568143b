#include "readings/data_notes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "readings/log/sample_use.hpp"
#include "tests/readings/read_data.hpp"

namespace reeve::testing {
namespace {

using Lines = std::vector<std::size_t>;

const std::string notes_header = "run,routing,held,motor_tension_N,T1_N,Ta_N,x\n";

Lines lines(const std::string& rows, NoteKind kind) {
  return noted_lines(read_data(notes_header + rows).notes, kind);
}

TEST(AMotorSideSegment, WithMoreThanTheMotorGivesIsNoted) {
  EXPECT_EQ(lines("A,TR5,,20,4,20.9,1\nA,TR5,,20,4,21.1,1\n", NoteKind::motor_side_above_motor),
            Lines{3});
  // Strands may carry more than the motor: releasing, or behind a pulley.
  EXPECT_EQ(lines("A,TR5,,20,30,10,1\n", NoteKind::motor_side_above_motor), Lines{});
}

std::string held_note(const std::string& columns, const std::string& rows) {
  const auto notes = read_data("run,routing,direction," + columns + "T1_N\n" + rows).notes;
  return note_text(notes, NoteKind::assumed);
}

TEST(AHeldFinger, ThatNoRowNamesIsAssumedToBeNone) {
  EXPECT_EQ(held_note("", "A,TR5,pull,4\nA,TR5,pull,5\n"),
            "the held finger is not given in 2 of 2 rows: none is assumed to be held");
  EXPECT_EQ(held_note("held,", "A,TR5,pull,,4\nA,M-1-F,pull,,5\n"),
            "the held finger is not given in 1 of 2 rows: none is assumed to be held");
  EXPECT_EQ(held_note("held,", "A,TR5,pull,none,4\nA,TR5,pull,none,5\n"), "");
  EXPECT_EQ(held_note("held,", "A,TR5,pull,,4\nA,TR5,pull,1,5\n"), "");
  EXPECT_EQ(held_note("", "A,M-1-F,pull,4\n"), "");
}

std::size_t unit_notes(const std::string& rows) {
  return count_notes(read_data("run,routing,motor_tension_N,T1_N\n" + rows).notes, NoteKind::units);
}

TEST(UnitsOffByAThousand, AreSuspected) {
  EXPECT_EQ(unit_notes("A,TR5,20,4\nA,TR5,25,5\n"), 0U);
  EXPECT_EQ(unit_notes("A,TR5,20,4000\nA,TR5,25,5000\n"), 1U);        // mN over N
  EXPECT_EQ(unit_notes("A,TR5,20,0.03\nA,TR5,25,0.03\n"), 1U);        // kN over N
  EXPECT_EQ(unit_notes("A,TR5,20000,4000\nA,TR5,25000,3000\n"), 1U);  // motor in mN
  EXPECT_EQ(unit_notes("A,TR5,,0.004\nA,TR5,,0.005\n"), 1U);
  EXPECT_EQ(unit_notes("A,TR5,20,0\nA,TR5,25,0\n"), 0U);
  const auto notes =
      read_data("run,routing,held,direction,motor_tension_N,T1_N\nA,TR5,1,release,20,4000\n").notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(
      notes[0].text,
      "the median of T1_N over motor_tension_N is 200, and from 0.002 to 20 is plausible: is it "
      "in another unit than newton?");
}

// What is above zero is noise, too, of a sensor that reads nothing.
TEST(TheUnitOfADeadSensor, IsNotAskedFor) {
  EXPECT_EQ(unit_notes("A,TR5,20,0.03\nA,TR5,25,0.02\nA,TR5,22,0.03\n"), 1U);
  EXPECT_EQ(unit_notes("A,TR5,20,0.03\nA,TR5,25,0.02\nA,TR5,22,-0.03\n"), 0U);
  EXPECT_EQ(unit_notes("A,TR5,20,0.03\nA,TR5,25,0.02\nA,TR5,22,0.03\nA,TR5,22,-0.03\n"), 1U);
}

TEST(AStuckSensor, IsLeftOutInItsRunAndNoted) {
  const auto rows = [](const std::string& run, auto reads) {
    std::string text;
    for (int i = 0; i < 6; ++i) {
      const double motor_N = 10 + 5 * i;
      text += run + ",TR5,," + std::to_string(motor_N) + "," + std::to_string(reads(motor_N)) +
              "," + std::to_string(motor_N / 2) + ",1\n";
    }
    return text;
  };
  const auto follows = [](double motor_N) { return motor_N / 5; };
  const auto near = [](double motor_N) { return motor_N / 5.5; };
  const auto hangs = [](double) { return 4.3; };
  const std::string others = rows("A", follows) + rows("B", near);
  const MeasuredData stuck = read_data(notes_header + others + rows("C", hangs));
  EXPECT_EQ(noted_lines(stuck.notes, NoteKind::stuck_channel), (Lines{14, 15, 16, 17, 18, 19}));
  for (const Reading& reading : stuck.readings) {
    EXPECT_EQ(reading.tension_N[0].has_value(), reading.run != 2U);
    EXPECT_TRUE(reading.tension_N[1].has_value());
  }
  EXPECT_EQ(lines(others + rows("C", follows), NoteKind::stuck_channel), Lines{});
  // One bad cell, here or in another run, is not what readings span.
  const std::string bad = "A,TR5,,20,-9999,10,1\n";
  EXPECT_EQ(lines(bad + others + rows("C", follows), NoteKind::stuck_channel), Lines{});
  const std::string slip = "C,TR5,,20,430,10,1\n";
  EXPECT_EQ(lines(bad + others + rows("C", hangs) + slip, NoteKind::stuck_channel).size(), 7U);
  // Small readings that follow the motor, beside runs that release, where they are much greater.
  const auto small = [](double motor_N) { return motor_N / 400; };
  EXPECT_EQ(lines(others + rows("C", small), NoteKind::stuck_channel), Lines{});
  // Rows that have nothing else go; a run that has nothing else is silent.
  const auto alone = [](const std::string& run, double by) {
    std::string text;
    for (int i = 1; i < 8; ++i) {
      text += run + ",M-F,," + std::to_string(10 * i) + "," +
              std::to_string(by > 0 ? 10 * i * by : 4.3) + ",\n";
    }
    return text;
  };
  const std::string two = "run,routing,held,motor_tension_N,Th1_N,T1_N\n" + alone("A", 0.3) +
                          alone("B", 0.31) + alone("C", 0);
  EXPECT_EQ(read_data(two + "C,M-1-F,,20,,5\n").readings.size(), 15U);
  EXPECT_EQ(read_data(two).runs, (std::vector<std::string>{"A", "B"}));
  // The same load, and the same reading.
  const std::string held = "C,TR5,,20,4,10,1\n";
  EXPECT_EQ(lines(others + held + held + held + held + held, NoteKind::stuck_channel), Lines{});
  // A sensor of coarse steps.
  const auto coarse = [](double motor_N) { return std::floor(motor_N / 15); };
  EXPECT_EQ(lines(rows("A", coarse) + rows("B", coarse) + rows("C", [](double) { return 1.0; }),
                  NoteKind::stuck_channel),
            Lines{});
}

TEST(ARunInWhichNoSensorSaysAnything, IsLeftOutAndNoted) {
  const std::string read = "A,TR5,,20,4,10,1\nA,TR5,,30,6,15,1\n";
  const auto data = [&](const std::string& rows) { return read_data(notes_header + read + rows); };
  const auto silent = [&](const std::string& rows) {
    return noted_lines(data(rows).notes, NoteKind::silent_run);
  };
  EXPECT_EQ(silent("B,TR5,,20,,,1\nB,TR5,,30,,,1\n"), (Lines{4, 5}));
  EXPECT_EQ(silent("B,TR5,,20,0,0,1\nB,TR5,,30,0,0,1\n"), (Lines{4, 5}));
  // A run is not silent at loads at which strands may be slack, or if one of its sensors reads.
  EXPECT_EQ(silent("B,TR5,,1,0,0,1\nB,TR5,,2,0,0,1\n"), Lines{});
  EXPECT_EQ(silent("B,TR5,,20,0,0,1\nB,TR5,,30,0,9,1\n"), Lines{});
  const MeasuredData left = data("B,TR5,,20,,,1\nC,TR5,,20,4,10,1\n");
  EXPECT_EQ(left.runs, (std::vector<std::string>{"A", "C"}));
  ASSERT_EQ(left.readings.size(), 3U);
  EXPECT_EQ(left.readings.back().run, 1U);
}

// One row of a run that has others is a fault of the file.
TEST(ARowWithoutATension, IsRefusedBesideOthersOfItsRun) {
  EXPECT_THROW(read_data(notes_header + "A,TR5,,20,4,10,1\nA,TR5,,30,,,1\n"), InputError);
  EXPECT_THROW(read_data(notes_header + "A,TR5,,20,,,1\nB,TR5,,30,,,1\n"), InputError);
}

TEST(ColumnsAndCommentsThatAreNoReadings, AreNoted) {
  const MeasuredData data =
      read_data("# source\n" + notes_header + "A,TR5,,20,4,10,1\n#A,TR5,,20,5,10,1\n");
  EXPECT_EQ(count_notes(data.notes, NoteKind::covariate), 1U);
  EXPECT_EQ(noted_lines(data.notes, NoteKind::comment), Lines{4});
}

// It gives rows their order, and `import` itself writes it.
TEST(AClockOfReadings, IsNotReported) {
  const std::string header = "run,routing,humidity,time_s,T1_N\n";
  const MeasuredData data = read_data(header + "A,TR5,1,0.5,4\nA,TR5,1,1.5,5\n");
  EXPECT_EQ(count_notes(data.notes, NoteKind::covariate), 1U);
  EXPECT_EQ(data.covariates.size(), 2U);
  // It has no time of one row, and orders none.
  const MeasuredData part = read_data(header + "A,TR5,1,0.5,4\nA,TR5,1,,5\n");
  EXPECT_EQ(count_notes(part.notes, NoteKind::covariate), 2U);
}

TEST(AColumnBesideAStrand, IsThatSegmentWhateverItsLetter) {
  const MeasuredData data = read_data(
      "run,routing,T1_N,at_T1_N,at_T4_N\nA,M-1-T-2-M,1,2,3\nA,1-T-2-P-1,1,2,3\nA,TR5,1,2,3\n");
  const auto reading = [&](std::size_t row, const std::string& segment) -> std::optional<double> {
    for (std::size_t c = 0; c < data.channels.size(); ++c) {
      if (data.channels[c].name == segment) return data.readings[row].tension_N[c];
    }
    return std::nullopt;
  };
  EXPECT_EQ(reading(0, "a"), 2);
  EXPECT_EQ(reading(0, "b"), 3);
  EXPECT_EQ(reading(1, "a"), 3);
  EXPECT_EQ(reading(1, "b"), 2);
  EXPECT_EQ(reading(2, "a"), 2);
  EXPECT_FALSE(reading(2, "b"));
  EXPECT_EQ(reading(2, "d"), 3);
  const MeasuredRouting& loop = data.routings[1];
  EXPECT_FALSE(loop.segments.back());  // d
  EXPECT_EQ(data_error("run,routing,T1_N,at_T2_N\nA,M-1-T-2-M,1,2\n"),
            "d.csv:2: column 'at_T2_N' = '2': the routing 'M-1-T-2-M' has no motor-side segment at "
            "T2: expected an empty cell; its segments are a, T1, T2, T3, T4, b");
  EXPECT_EQ(data_error("run,routing,Ta_N,at_T1_N\nA,M-1-T-2-M,1,2\n"),
            "d.csv:2: column 'at_T1_N' = '2': in the routing 'M-1-T-2-M' that is segment a, which "
            "another column has: expected an empty cell in one of the two");
}

// A name that has slipped moves all behind it.
TEST(KindsOfNotes, HaveTheNamesThatFilesHave) {
  EXPECT_STREQ(note_kind_name(NoteKind::time_series), "time_series");
  EXPECT_STREQ(note_kind_name(NoteKind::not_as_pulled), "not_as_pulled");
  EXPECT_STREQ(note_kind_name(NoteKind::inverted), "inverted");
  EXPECT_STREQ(note_kind_name(NoteKind::sparse), "sparse");
  EXPECT_STREQ(sample_use_name(SampleUse::settling), "settling");
  EXPECT_STREQ(sample_use_name(SampleUse::too_few), "too_few");
}

TEST(Letters, ThatThePaperUsesOtherwiseAreNoted) {
  const auto letters = [](const std::string& column, const std::string& routing) {
    return note_text(read_data("run,routing,T1_N," + column + "\nA," + routing + ",1,2\n").notes,
                     NoteKind::letters);
  };
  EXPECT_EQ(letters("Ta_N", "1-T-2-P-1"),
            "letters run in walk order: in 1-T-2-P-1 a is beside T4. Where a, b, c, d were meant "
            "beside T1, T2, T3, T4, name the columns at_T1_N and so on");
  for (const char* same : {"M-1-T-2-F", "M-1-P-2-F", "M-1-P-2-M"}) {
    EXPECT_EQ(letters("Ta_N", same), "") << same;
  }
  for (const char* other : {"M-1-T-2-M", "F-1-P-2-F", "1-P-2-P-1"}) {
    EXPECT_NE(letters("Tb_N", other), "") << other;
  }
  EXPECT_EQ(letters("at_T4_N", "1-T-2-P-1"), "");
  const MeasuredData none = read_data("run,routing,T1_N,Ta_N\nA,1-T-2-P-1,1,\nA,M-1-F,1,2\n");
  EXPECT_EQ(count_notes(none.notes, NoteKind::letters),
            0U);  // no letter of that routing is measured
}

}  // namespace
}  // namespace reeve::testing
