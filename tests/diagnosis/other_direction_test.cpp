// Directions that are written down the other way in one run of planted data, and motor tensions a
// row late.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/diagnose.hpp"
#include "diagnosis/verdict/model_doubts.hpp"
#include "diagnosis/verdict/run_words.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/has.hpp"
#include "tests/support/planting.hpp"
#include "tests/support/sanitizers.hpp"

namespace reeve::testing {
namespace {

MeasuredData planted_directions(const PlantingPlan& plan, std::uint64_t seed) {
  return read_data(plant(plan, seed).csv);
}

std::optional<DataNote> odd_directions(const MeasuredData& data) {
  return note_on_other_direction(data, all_readings(data), {});
}

// Of so many of the rows of a run; their lines.
std::vector<std::size_t> exchange(MeasuredData& data, std::size_t run, std::size_t one_in) {
  std::vector<std::size_t> lines;
  std::size_t row = 0;
  for (Reading& reading : data.readings) {
    if (reading.run != run || row++ % one_in != 0) continue;
    reading.direction = reading.direction == Direction::pull ? Direction::release : Direction::pull;
    lines.push_back(reading.line);
  }
  return lines;
}

void expect_most_of(const std::vector<std::size_t>& lines, const DataNote& note) {
  EXPECT_GE(note.lines.size(), lines.size() * 2 / 3);
  for (const std::size_t line : note.lines) {
    EXPECT_NE(std::find(lines.begin(), lines.end(), line), lines.end()) << line;
  }
}

TEST(TheOtherDirection, IsSeenInARunWhereAllOrSomeAreExchanged) {
  const MeasuredData data = planted_directions({}, 81);
  ASSERT_FALSE(odd_directions(data));
  for (std::size_t run = 0; run < data.runs.size(); ++run) {
    for (const std::size_t one_in : {1U, 2U}) {
      MeasuredData wrong = data;
      const auto lines = exchange(wrong, run, one_in);
      const auto note = odd_directions(wrong);
      ASSERT_TRUE(note) << data.runs[run];
      expect_most_of(lines, *note);
      EXPECT_TRUE(has(note->text, " of " + runs_text({run}, data) + " read"));
    }
  }
}

TEST(TheOtherDirection, IsNotSeenInOneRowOfTen) {
  MeasuredData data = planted_directions({}, 81);
  exchange(data, 0, 10);
  EXPECT_FALSE(odd_directions(data));
}

// Three rows of M-1-F, of which T1 = T_M e^{-0.36π} is forecast, read as if released; others, here
// so many e-folds below the motor.
std::optional<DataNote> beside_others(double below) {
  std::string text = "run,routing,direction,motor_tension_N,T1_N\n";
  for (int i = 0; i < 8; ++i) text += fmt::format("A,M-1-F,pull,10,{}\n", 10 * std::exp(-below));
  for (int i = 0; i < 3; ++i) text += fmt::format("B,M-1-F,pull,10,{}\n", 10 * std::exp(1));
  return odd_directions(read_data(text));
}

TEST(TheOtherDirection, IsNotSeenWhereOtherRowsAreAsFarOff) {
  EXPECT_TRUE(beside_others(1.1));
  EXPECT_FALSE(beside_others(0));
}

// Whatever else is wrong with the rig, with each kind of noise by turns.
TEST(TheOtherDirection, IsNotSeenWhereItIsRight) {
  SKIP_UNDER_SANITIZERS();
  std::uint64_t seed = 0;
  for (const EffectKind effect : library_effects()) {
    ++seed;
    PlantingPlan plan;
    plan.effects = {effect};
    plan.size = EffectSize::large;
    plan.noise = seed % 2 == 0 ? high_noise : low_noise;
    plan.noise.tail_degrees = seed % 3 == 0 ? 3 : 0;
    const auto note = odd_directions(planted_directions(plan, seed));
    EXPECT_FALSE(note) << planted_name(effect) << ' ' << seed << ' ' << note->text;
  }
}

TEST(ShiftedRows, AreSeenWhereTheMotorTensionIsOfTheRowBeforeOrBehind) {
  const MeasuredData data = planted_directions({}, 81);
  EXPECT_FALSE(note_on_shifted_rows(data, all_readings(data), {}));
  for (const bool late : {true, false}) {
    MeasuredData wrong = data;
    for (std::size_t i = 1; i < data.readings.size(); ++i) {
      const std::size_t from = late ? i - 1 : i;
      wrong.readings[late ? i : i - 1].motor_tension_N = data.readings[from].motor_tension_N;
    }
    const auto note = note_on_shifted_rows(wrong, all_readings(wrong), {});
    ASSERT_TRUE(note);
    EXPECT_TRUE(has(note->text, late ? "of the row behind them" : "of the row before them"));
    // Coefficients that fit them would be wrong.
    const DiagnosisResult result = diagnose(wrong, {}, {});
    EXPECT_EQ(result.verdict, Verdict::unexplained);
    EXPECT_EQ(result.unexplained->where, "motor_tension_N");
    EXPECT_TRUE(result.causes.empty());
  }
}

}  // namespace
}  // namespace reeve::testing
