#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/diagnosis/read_dataset.hpp"

namespace reeve {
namespace {

using testing::all_of;
using testing::count_notes;
using testing::data_error;
using testing::noted_lines;
using testing::read_data;

using Lines = std::vector<std::size_t>;

const std::string five_columns = "run,routing,motor_tension_N,T1_N,T2_N\n";

TEST(TensionsBelowZero, AreReadingsAndAreCounted) {
  const MeasuredData data =
      read_data(five_columns + "A,TR5,20,4,-0.1\nA,TR5,20,5,0\nA,TR5,0,-0.2,-0.3\nA,TR5,20,4,\n");
  ASSERT_EQ(data.readings.size(), 4U);
  EXPECT_EQ(data.readings[0].tension_N[1], -0.1);
  EXPECT_EQ(all_of(data).cells[1].measured_N, -0.1);
  EXPECT_EQ(noted_lines(data.notes, NoteKind::below_zero), (Lines{2, 4}));
  EXPECT_EQ(data.notes.back().text,
            "readings below zero (1 of 4 of T1, 2 of 3 of T2) are used as they are: a zero that "
            "drifts gives them. A tare row takes it off");
}

TEST(TensionsBelowZero, AreNotNotedWhereThereAreNone) {
  EXPECT_EQ(count_notes(read_data(five_columns + "A,TR5,20,4,0\n").notes, NoteKind::below_zero),
            0U);
}

// Of T and -T no share can be taken, nor of less.
TEST(TensionsBelowZero, WithoutAMotorTensionNeedAPositiveSum) {
  const MeasuredData data =
      read_data("run,routing,T1_N,T2_N\nA,TR5,1,-1\nA,TR5,1,-2\nA,TR5,2,-1\n");
  ASSERT_EQ(all_of(data).rows.size(), 1U);
  EXPECT_EQ(all_of(data).rows[0].reading, 2U);
}

// T1 and T2 over ten loads.
std::string inverted_note(double per_load, double zero_N) {
  std::string text = "run,routing,direction,motor_tension_N,T1_N,T2_N\n";
  for (int i = 1; i <= 10; ++i) {
    const double drift = 0.1 * (i % 3);
    text += fmt::format("A,TR5,pull,{},{},{}\n", 10 * i, 5 * i, per_load * 10 * i + zero_N + drift);
    // Of which a tenth arrives there, in other order.
    const int load = 10 * (1 + i * 3 % 10);
    text +=
        fmt::format("A,TR5,release,{},{},{}\n", load, 15 * load, 0.1 * per_load * load + zero_N);
  }
  return testing::note_text(read_data(text).notes, NoteKind::inverted);
}

TEST(AChannel, WhoseReadingsFallBelowZeroUnderLoadHasAWrongSign) {
  EXPECT_EQ(inverted_note(-0.3, 0),
            "T2 reads below zero, the more so the more is pulled, which no tendon does: exchange "
            "the sign in the file if the sensor is mounted or wired the other way round");
  EXPECT_EQ(inverted_note(0.3, 0), "");
  EXPECT_EQ(inverted_note(0, -2), "") << "a slack strand and a zero that has drifted";
  EXPECT_EQ(inverted_note(0.01, -2), "");
  EXPECT_EQ(inverted_note(-0.3, 20), "") << "most are above";
}

TEST(AMotorTensionBelowZero, LeavesItsRowOutAndIsNamed) {
  const MeasuredData data = read_data(five_columns + "A,TR5,-0.1,4,3\nA,TR5,0,5,3\nB,TR5,-2,5,3\n");
  ASSERT_EQ(data.readings.size(), 1U);
  EXPECT_EQ(data.readings[0].line, 3U);
  EXPECT_EQ(noted_lines(data.notes, NoteKind::not_compared), (Lines{2, 4}));
}

TEST(AMotorTensionBelowZero, InEveryRowIsAnError) {
  EXPECT_EQ(data_error(five_columns + "A,TR5,-1,4,3\n"),
            "d.csv: motor_tension_N is below zero in every row: expected motor tensions from 0: "
            "exchange the sign of that column");
}

}  // namespace
}  // namespace reeve
