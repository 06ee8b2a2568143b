#include "readings/copies.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "numerics/random.hpp"
#include "tests/readings/read_data.hpp"

namespace reeve::testing {
namespace {

using Lines = std::vector<std::size_t>;

const std::string copies_header = "run,routing,held,motor_tension_N,T1_N,Ta_N,row\n";

MeasuredData rows_of(const std::string& rows) { return read_data(copies_header + rows); }

TEST(Copies, AreFoundUnderARunningNumberAndKept) {
  const MeasuredData data = rows_of(
      "A,TR5,,20.013,4.1372,10.0251,1\n"
      "A,TR5,,20.013,5.2213,10.0251,2\n"
      "A,M-1-P-2-M,,20.0130,4.13720,1.00251e1,3\n"
      "A,TR5,,20.013,4.1372,10.0251,4\n");
  EXPECT_EQ(noted_lines(data.notes, NoteKind::duplicate), (Lines{4, 5}));
  EXPECT_EQ(count_notes(data.notes, NoteKind::duplicate_across_runs), 0U);
  EXPECT_EQ(data.readings.size(), 4U);
  EXPECT_EQ(repeated_readings(data), (std::vector<std::size_t>{2, 3}));
}

TEST(Copies, AreLeakageUnderAnotherRun) {
  const MeasuredData data = rows_of(
      "A,TR5,,20.013,4.1372,10.0251,1\n"
      "B,TR5,,20.013,4.1372,10.0251,1\n"
      "B,TR5,,20.013,4.1372,10.0251,1\n"
      "C,TR5,,20.013,4.1372,10.0251,1\n");
  EXPECT_EQ(noted_lines(data.notes, NoteKind::duplicate_across_runs), (Lines{3, 5}));
  EXPECT_EQ(noted_lines(data.notes, NoteKind::duplicate), Lines{4});
}

TEST(RowsThatDifferInOneTension, AreNoCopies) {
  const std::string first = "A,TR5,,20.013,4.1372,10.0251,1\n";
  for (const char* other : {"A,TR3,,20.013,4.1372,10.0251,1\n", "A,TR5,1,20.013,4.1372,10.0251,1\n",
                            "A,TR5,,20.014,4.1372,10.0251,1\n", "A,TR5,,20.013,4.1373,10.0251,1\n",
                            "A,TR5,,20.013,4.1372,,1\n"}) {
    EXPECT_TRUE(repeated_readings(read_data(copies_header + first + other)).empty()) << other;
  }
}

// Readings at five loads with an error of one per cent, in steps of `step`.
std::string stepped(int rows, double step) {
  std::string text = "run,routing,motor_tension_N,T1_N,T2_N,T3_N,T4_N\n";
  const std::vector<double> shares{0.18, 0.10, 0.07, 0.05};
  for (int i = 0; i < rows; ++i) {
    const double motor_N = 10.0 + 10 * (i % 5);
    text += fmt::format("{},TR5,{}", i / 40, motor_N);
    for (std::size_t c = 0; c < shares.size(); ++c) {
      const double draw = 2 * uniform(3, 0, static_cast<std::uint64_t>(i) * 4 + c) - 1;
      const double tension_N = shares[c] * motor_N * (1 + 0.02 * draw);
      text += fmt::format(",{:.4f}", step * std::round(tension_N / step));
    }
    text += '\n';
  }
  return text;
}

TEST(CoarseSensors, GiveEqualRowsThatAreNoCopies) {
  const MeasuredData data = read_data(stepped(326, 0.1));
  const EqualRows equal = equal_rows(data);
  EXPECT_GT(equal.by_chance.size(), 50U);
  EXPECT_TRUE(repeated_readings(data).empty());
  EXPECT_EQ(noted_lines(data.notes, NoteKind::equal_by_chance).size(), equal.by_chance.size());
}

TEST(CoarseSensors, GiveNoLongStretches) {
  std::string text = stepped(326, 0.1);
  for (int i = 0; i < 12; ++i) text += "9,TR5,50,8.9,5.0,3.5,2.6\n";
  const MeasuredData data = read_data(text);
  const auto copies = repeated_readings(data);
  ASSERT_EQ(copies.size(), 11U);
  EXPECT_EQ(data.readings[copies.front()].line, 329U);
}

// Sensors that cannot read below zero, of strands that carry nothing: where three of four readings
// are 0, both of two are in every second row.
TEST(SensorsAtZero, GiveEqualRowsThatAreNoCopies) {
  std::string rows;
  for (int i = 0; i < 40; ++i) {
    const auto reading = [&](std::uint32_t channel) {
      const double u = uniform(5, channel, static_cast<std::uint64_t>(i));
      return u < 0.75 ? 0 : 0.1 * (u - 0.75);
    };
    rows += fmt::format("{},TR5,,{},{},{},{}\n", i % 2 == 0 ? "A" : "B", 10 + 10 * (i / 20),
                        reading(1), reading(2), i);
  }
  const MeasuredData data = rows_of(rows);
  EXPECT_EQ(count_notes(data.notes, NoteKind::duplicate_across_runs), 0U);
  EXPECT_GT(count_notes(data.notes, NoteKind::equal_by_chance), 0U);
}

TEST(FineSensors, GiveNoEqualRows) {
  std::string text = stepped(326, 0.001);
  EXPECT_TRUE(equal_rows(read_data(text)).by_chance.empty());
  // One copy, far from what it was copied from.
  const std::size_t begin = text.find("\n3,TR5") + 1;
  text += text.substr(begin, text.find('\n', begin) - begin + 1);
  EXPECT_EQ(noted_lines(read_data(text).notes, NoteKind::duplicate), Lines{328});
}

// Without noise a repetition is the same to the last digit, and nothing is wrong with it.
TEST(SimulatedRows, MayRepeatToTheLastDigit) {
  std::string text = "# simulated\nrun,routing,motor_tension_N,T1_N,T2_N,repeat\n";
  for (int i = 0; i < 400; ++i) {
    const double motor_N = 10 + 20 * uniform(5, 0, static_cast<std::uint64_t>(i / 2));
    text += fmt::format("A,TR5,{},{:.6g},{:.6g},{}\n", motor_N, motor_N * 0.1834159,
                        motor_N * 0.1041927, i % 2 + 1);
  }
  EXPECT_TRUE(repeated_readings(read_data(text)).empty());
  text.replace(0, 11, "# measured ");
  EXPECT_EQ(repeated_readings(read_data(text)).size(), 200U);
}

TEST(OneChannel, SaysLittleOfCopies) {
  const MeasuredData data = read_data("run,routing,T1_N\nA,TR5,4.137\nA,TR5,4.137\nA,TR5,4.15\n");
  EXPECT_TRUE(repeated_readings(data).empty());
  EXPECT_EQ(noted_lines(data.notes, NoteKind::equal_by_chance), Lines{3});
}

}  // namespace
}  // namespace reeve::testing
