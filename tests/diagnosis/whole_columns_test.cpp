// Columns with empty cells, against the values that were taken out.
#include "diagnosis/whole_columns.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "causes/term.hpp"
#include "diagnosis/diagnose.hpp"
#include "numerics/random.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

constexpr std::uint64_t row_seed = 11;

// Six runs of ten rows of M-1-F. The column is that of the row's number from 0; empty where it is
// left out.
template <typename Column>
MeasuredData with_column(Column column) {
  std::string text = "run,routing,direction,motor_tension_N,T1_N,h_pct\n";
  for (int i = 0; i < 60; ++i) {
    const std::optional<double> h = column(i);
    text += fmt::format("{},M-1-F,pull,{},{},{}\n", i / 10, 10 + i % 7, 3 + i % 5,
                        h ? fmt::format("{}", *h) : "");
  }
  return read_data(text);
}

double drawn(int i) { return 40 + 40 * uniform(row_seed, 0, static_cast<std::uint64_t>(i)); }

TEST(WholeColumns, AreAsGivenIfNoCellIsEmpty) {
  const MeasuredData data = with_column([](int i) { return drawn(i); });
  const WholeColumns whole = whole_columns(data);
  EXPECT_TRUE(whole.incomplete.empty());
  EXPECT_EQ(whole.data.notes.size(), data.notes.size());
}

TEST(FilledColumns, HaveTheLineBetweenNeighboursWhereTheyChangeSlowly) {
  const auto slow = [](int i) { return 40 + 5.0 * (i / 10) + 0.5 * (i % 10); };
  const MeasuredData data = with_column([&](int i) {
    const bool is_empty = i % 3 == 1 || i == 0 || i == 9;
    return is_empty ? std::nullopt : std::optional(slow(i));
  });
  for (int i = 2; i < 60; ++i) {
    if (i % 10 == 9 || i % 10 == 0) continue;
    EXPECT_NEAR(*data.readings[static_cast<std::size_t>(i)].covariates[0], slow(i), 1e-9);
  }
  // What is before the first one of a run, or behind the last, is as that one.
  EXPECT_EQ(data.readings[0].covariates[0], slow(2));
  EXPECT_EQ(data.readings[9].covariates[0], slow(8));
  EXPECT_TRUE(has(note_text(data.notes, NoteKind::assumed),
                  "column 'h_pct' is empty in 22 of 60 rows, filled in 22 by the rows beside"));
}

TEST(FilledColumns, HaveTheMeanOfTheirRunWhereTheyScatterAboutIt) {
  const auto noisy = [](int i) { return 30 + 10.0 * (i / 10) + (i % 2 == 0 ? 1 : -1); };
  const MeasuredData data =
      with_column([&](int i) { return i % 10 == 4 ? std::nullopt : std::optional(noisy(i)); });
  for (std::size_t run = 0; run < 6; ++run) {
    EXPECT_NEAR(*data.readings[10 * run + 4].covariates[0],
                30 + 10.0 * static_cast<double>(run) - 1.0 / 9, 1e-9);
  }
  EXPECT_TRUE(has(note_text(data.notes, NoteKind::assumed), "by the mean of the run"));
}

TEST(WholeColumns, LeaveOutRowsWhereTheyAreSetRowByRow) {
  const WholeColumns whole = whole_columns(with_column(
      [](int i) { return i == 7 || i == 30 ? std::nullopt : std::optional(drawn(i)); }));
  EXPECT_EQ(whole.incomplete, (std::vector<std::size_t>{7, 30}));
  EXPECT_EQ(noted_lines(whole.data.notes, NoteKind::not_compared),
            (std::vector<std::size_t>{9, 32}));
}

TEST(WholeColumns, AreNotLookedAtIfTheyLackTooMuch) {
  const WholeColumns whole = whole_columns(
      with_column([](int i) { return i % 5 < 2 ? std::nullopt : std::optional(drawn(i)); }));
  EXPECT_TRUE(whole.incomplete.empty());
  for (const Reading& reading : whole.data.readings) EXPECT_FALSE(reading.covariates[0]);
  EXPECT_TRUE(has(note_text(whole.data.notes, NoteKind::not_compared), "it is not looked at"));
}

// Each is empty in another third of the rows.
TEST(WholeColumns, LeaveOutAThirdOfTheRowsTogether) {
  std::string text = "run,routing,motor_tension_N,T1_N,a,b,c\n";
  for (int i = 0; i < 30; ++i) {
    const auto cell = [&](int column) {
      return i % 3 == column ? std::string() : fmt::format("{}", drawn(3 * i + column));
    };
    text += fmt::format("{},M-1-F,{},3,{},{},{}\n", i / 10, 10 + i, cell(0), cell(1), cell(2));
  }
  const WholeColumns whole = whole_columns(read_data(text));
  EXPECT_EQ(whole.incomplete.size(), 10U);
  EXPECT_EQ(count_notes(whole.data.notes, NoteKind::not_compared), 3U);
}

// Sheath friction that grows by 0.8 % for each per cent of humidity, which was not always noted.
TEST(WholeColumns, LeaveALawAsItIs) {
  std::string text = "run,routing,direction,motor_tension_N,T1_N,h_pct\n";
  std::uint64_t draw = 0;
  for (int run = 0; run < 8; ++run) {
    for (int i = 0; i < 20; ++i) {
      const double h = 40 + 5 * run + 0.3 * i;
      const double phi = 0.18 * 2 * std::numbers::pi * (1 + 0.008 * (h - 55));
      const double motor_N = 10 + 30 * uniform(row_seed, 1, draw);
      const double read_N = motor_N * std::exp(-phi) * (1 + 0.01 * normal(row_seed, 2, draw));
      const bool is_empty = uniform(row_seed, 3, draw++) < 0.4;
      text += fmt::format("{},M-1-F,pull,{:.4f},{:.5f},{}\n", run, motor_N, read_N,
                          is_empty ? "" : fmt::format("{:.2f}", h));
    }
  }
  const DiagnosisResult result = diagnose(read_data(text), {}, {});
  ASSERT_FALSE(result.causes.empty());
  const Effect& effect = result.causes.front().effect;
  ASSERT_TRUE(has(effect_name(effect), "h_pct")) << effect_name(effect);
  const Term* law = term_of(*effect.cause);
  ASSERT_NE(law, nullptr);
  const double rise =
      law_value(*law, 70, 0, effect.values.data()) - law_value(*law, 45, 0, effect.values.data());
  // Each exponent is phi (1 + f) of the hardware's, which is that at 55 %.
  EXPECT_NEAR(rise, 0.008 * 25, 0.1 * 0.008 * 25) << effect_name(effect);
}

}  // namespace
}  // namespace reeve::testing
