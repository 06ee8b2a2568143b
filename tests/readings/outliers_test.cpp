#include "readings/outliers.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "numerics/random.hpp"
#include "readings/polished_levels.hpp"
#include "tests/readings/read_data.hpp"

namespace reeve::testing {
namespace {

// Of the rows' loads 1, 1, 1, 1 and 4 channel 0 knows nothing. It tells of them all the same unless
// more than one of its five cells are zeros; then the last load is 2, between what the two say.
TEST(PolishedLevels, PassOverAChannelThatReadsNothingMoreThanOnceInFive) {
  for (const auto& [zeros, load] : {std::pair{1U, 2.0}, {2U, 4.0}}) {
    readings::KindCells cells;
    for (std::size_t row = 0; row < 5; ++row) {
      cells.push_back({row, 0, row < zeros ? 0.0 : 1.0});
      cells.push_back({row, 1, row < 4 ? 1.0 : 4.0});
    }
    const auto levels = readings::polished_levels(cells, 2);
    EXPECT_NEAR(levels.expected_N({4, 1, 0}), load, 1e-12);
  }
}

using Lines = std::vector<std::size_t>;

// Row r: its run, its motor tension and four strands.
struct PlainRow {
  std::string run;
  double motor_N = 0;
  std::vector<double> tension_N;
};

// Runs of eight rows from 10 to 45 N; every reading has an error of two per cent and 0.05 N.
std::vector<PlainRow> plain_rows(int runs = 4) {
  const std::vector<double> shares{0.18, 0.10, 0.03, 0.02};
  std::vector<PlainRow> rows;
  for (int i = 0; i < 8 * runs; ++i) {
    PlainRow row{fmt::format("run{}", i / 8), 10.0 + 5 * (i % 8), {}};
    for (std::size_t c = 0; c < shares.size(); ++c) {
      const auto draw = [&](std::uint32_t what) {
        return 2 * uniform(7, what, static_cast<std::uint64_t>(i) * 4 + c) - 1;
      };
      row.tension_N.push_back(shares[c] * row.motor_N * (1 + 0.02 * draw(1)) + 0.05 * draw(2));
    }
    rows.push_back(row);
  }
  return rows;
}

std::string file_of(const std::vector<PlainRow>& rows, bool with_motor = true) {
  std::string text = "run,routing,motor_tension_N,T1_N,T2_N,T3_N,T4_N\n";
  for (const PlainRow& row : rows) {
    text += row.run + ",TR5," + (with_motor ? fmt::format("{}", row.motor_N) : "");
    for (const double tension : row.tension_N) text += fmt::format(",{}", tension);
    text += '\n';
  }
  return text;
}

// Behind a contact that lets nothing through, sensors that cannot read below zero read noise, and
// nothing in most rows.
TEST(AnOutlier, IsNoLoadAboveSensorsThatReadNothing) {
  auto rows = plain_rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t c = 0; c < 4; ++c) {
      const bool reads = i == 21 ? c < 3 : c == i % 4;
      const double noise_N = (i == 21 ? 0.04 : 0.001) * (1 + uniform(3, 1, 4 * i + c));
      rows[i].tension_N[c] = reads ? noise_N : 0;
    }
  }
  const MeasuredData data = read_data(file_of(rows));
  for (const DataNote& note : data.notes) EXPECT_NE(note.kind, NoteKind::outlier) << note.text;
  for (const Reading& reading : data.readings) EXPECT_TRUE(reading.motor_tension_N);
}

// The motor tensions of 32 rows, no two alike, come in an order in which neighbours differ.
std::vector<PlainRow> shuffled_rows() {
  auto rows = plain_rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double motor_N = 10.0 + 35.0 * static_cast<double>(i * 13 % 32) / 31;
    for (double& tension_N : rows[i].tension_N) tension_N *= motor_N / rows[i].motor_N;
    rows[i].motor_N = motor_N;
  }
  return rows;
}

TEST(AHeldValue, IsLeftOutAndNamed) {
  auto rows = shuffled_rows();
  for (const std::size_t i : {3U, 11U, 20U}) rows[i].tension_N[0] = rows[i - 1].tension_N[0];
  rows[28].motor_N = rows[27].motor_N;
  const MeasuredData data = read_data(file_of(rows));
  for (const std::size_t i : {3U, 11U, 20U}) EXPECT_FALSE(data.readings[i].tension_N[0]);
  EXPECT_FALSE(data.readings[28].motor_tension_N);
  EXPECT_EQ(noted_lines(data.notes, NoteKind::outlier), (Lines{5, 13, 22, 30}));
  const std::string text = note_text(data.notes, NoteKind::outlier);
  EXPECT_NE(text.find("does the logger hold its last value?"), std::string::npos) << text;
}

// What a sensor reads at its end comes more than once.
TEST(AHeldValue, IsNoEndOfASensor) {
  auto rows = shuffled_rows();
  for (PlainRow& row : rows) row.tension_N[0] = std::min(row.tension_N[0], 3.0);
  const MeasuredData data = read_data(file_of(rows));
  for (const DataNote& note : data.notes) EXPECT_NE(note.kind, NoteKind::outlier) << note.text;
}

TEST(AnOutlier, IsLeftOutAsACellAndNamed) {
  for (const bool with_motor : {true, false}) {
    auto rows = plain_rows();
    rows[12].tension_N[1] = 1e9;
    const MeasuredData data = read_data(file_of(rows, with_motor));
    EXPECT_FALSE(data.readings[12].tension_N[1]);
    EXPECT_TRUE(data.readings[12].tension_N[0]);
    EXPECT_EQ(data.readings.size(), rows.size());
    EXPECT_EQ(noted_lines(data.notes, NoteKind::outlier), Lines{14});
    const std::string text = note_text(data.notes, NoteKind::outlier);
    EXPECT_EQ(text.substr(0, 32), "T2 reads 1e+09 N in line 14, whe") << text;
    EXPECT_EQ(text.substr(text.find(". These")),
              ". These readings are left out: are they slips of a decimal point?");
  }
}

TEST(AnOutlier, MayBeASlipOfTen) {
  for (const double factor : {10.0, 0.1}) {
    auto rows = plain_rows();
    rows[7].tension_N[0] *= factor;
    const MeasuredData data = read_data(file_of(rows));
    EXPECT_EQ(noted_lines(data.notes, NoteKind::outlier), Lines{9}) << factor;
    EXPECT_FALSE(data.readings[7].tension_N[0]);
  }
}

TEST(AnOutlier, MayBeTheMotorTension) {
  auto rows = plain_rows();
  rows[20].motor_N *= 10;
  const MeasuredData data = read_data(file_of(rows));
  EXPECT_EQ(noted_lines(data.notes, NoteKind::outlier), Lines{22});
  EXPECT_FALSE(data.readings[20].motor_tension_N);
  EXPECT_TRUE(data.readings[20].tension_N[0]);
}

// Of two that do not fit, the scale is believed.
TEST(AnOutlier, BesideTheMotorTensionAloneIsTheStrands) {
  std::string text = "run,routing,motor_tension_N,T1_N\n";
  for (int i = 0; i < 12; ++i) {
    text += fmt::format("A,TR5,{},{}\n", 10 + i, (i == 4 ? 2 : 0.2) * (10 + i) + 0.01 * (i % 3));
  }
  const MeasuredData data = read_data(text);
  EXPECT_EQ(noted_lines(data.notes, NoteKind::outlier), Lines{6});
  EXPECT_EQ(data.readings.size(), 11U);  // of that row nothing is left
}

TEST(AnOutlier, MayBeFarBelowZero) {
  auto rows = plain_rows();
  rows[3].tension_N[3] = -999;
  EXPECT_EQ(noted_lines(read_data(file_of(rows)).notes, NoteKind::outlier), Lines{5});
  rows[3].tension_N[3] = -0.1;
  EXPECT_EQ(count_notes(read_data(file_of(rows)).notes, NoteKind::outlier), 0U);
}

void expect_no_outlier(const std::function<void(std::vector<PlainRow>&)>& change) {
  auto rows = plain_rows();
  change(rows);
  const MeasuredData data = read_data(file_of(rows));
  EXPECT_EQ(count_notes(data.notes, NoteKind::outlier), 0U)
      << note_text(data.notes, NoteKind::outlier);
  for (const Reading& reading : data.readings) {
    for (const auto& tension : reading.tension_N) EXPECT_TRUE(tension);
  }
}

TEST(OrdinaryReadings, HaveNoOutliers) {
  expect_no_outlier([](auto&) {});
  expect_no_outlier([](auto& rows) { rows[9].tension_N[2] *= 3; });
  // Where the load is small, noise is as large as what is measured.
  expect_no_outlier([](auto& rows) {
    for (int i : {3, 11, 19}) {
      for (double& tension : rows[static_cast<std::size_t>(i)].tension_N) tension *= 0.01;
      rows[static_cast<std::size_t>(i)].motor_N *= 0.01;
      rows[static_cast<std::size_t>(i)].tension_N[3] += 0.05;
    }
  });
}

// That is a cause: a sensor's gain in one run, or most of a row.
TEST(ADifferenceBetweenRuns, IsNoOutlier) {
  expect_no_outlier([](auto& rows) {
    for (std::size_t i = 8; i < 16; ++i) rows[i].tension_N[1] *= 20;
  });
  expect_no_outlier([](auto& rows) {
    const std::vector<double> factors{30, 0.01, 40, 1};
    for (std::size_t c = 0; c < 4; ++c) rows[5].tension_N[c] *= factors[c];
  });
}

TEST(TooManyOutliers, AreNotedAndKept) {
  auto rows = plain_rows();
  for (std::size_t i = 0; i < rows.size(); i += 6) rows[i].tension_N[i % 4] *= 30;
  const MeasuredData data = read_data(file_of(rows));
  EXPECT_TRUE(data.readings[0].tension_N[0]);
  const std::string text = note_text(data.notes, NoteKind::outlier);
  EXPECT_EQ(text.substr(text.find("; and")),
            "; and 1 more. That is more than slips are, so nothing is left out");
}

TEST(FewRows, HaveNoOutliers) {
  auto rows = plain_rows();
  rows.resize(4);
  rows[0].tension_N[0] = 1e6;
  EXPECT_EQ(count_notes(read_data(file_of(rows)).notes, NoteKind::outlier), 0U);
}

// A sensor that shows whole newtons reads 1 where 0.2 are.
TEST(ACoarseSensor, HasNoOutliersOfItsSteps) {
  std::vector<PlainRow> rows;
  for (int i = 0; i < 40; ++i) {
    rows.push_back({"A", 20, {4, 3, i == 17 ? 7.0 : 1.0, 2}});
  }
  EXPECT_EQ(count_notes(read_data(file_of(rows)).notes, NoteKind::outlier), 0U);
}

}  // namespace
}  // namespace reeve::testing
