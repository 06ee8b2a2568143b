// Sensors that step, stick or scatter in planted data, where nothing else is wrong.
#include "diagnosis/verdict/outlier_groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "diagnosis/diagnose.hpp"
#include "numerics/random.hpp"
#include "readings/stuck_channels.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/has.hpp"
#include "tests/support/planting.hpp"
#include "tests/support/sanitizers.hpp"

namespace reeve::testing {
namespace {

constexpr std::uint64_t quiet_seed = 81;

DiagnosisResult diagnosed_far(const MeasuredData& data) {
  DiagnoseOptions options;
  options.replicates = 400;
  return diagnose(data, Hardware{}, options);
}

MeasuredData planted_runs(const PlantingPlan& plan, std::uint64_t seed) {
  return read_data(plant(plan, seed).csv);
}

using Fault = std::function<double(double tension_N, std::size_t index)>;

using Runs = std::set<std::size_t>;

Runs later_half(const MeasuredData& data) {
  Runs runs;
  for (std::size_t run = data.runs.size() / 2; run < data.runs.size(); ++run) runs.insert(run);
  return runs;
}

// The sensor of T2 makes this of its readings in these runs.
MeasuredData with_fault(MeasuredData data, const Runs& runs, const Fault& fault) {
  constexpr std::size_t channel = 1;
  std::size_t index = 0;
  for (Reading& reading : data.readings) {
    std::optional<double>& tension = reading.tension_N[channel];
    if (tension && runs.contains(reading.run)) tension = fault(*tension, index++);
  }
  return data;
}

std::set<std::string> runs_of_lines(const MeasuredData& data,
                                    const std::vector<std::size_t>& lines) {
  std::set<std::string> runs;
  for (const Reading& reading : data.readings) {
    if (std::binary_search(lines.begin(), lines.end(), reading.line)) {
      runs.insert(data.runs[reading.run]);
    }
  }
  return runs;
}

// Cycles and the order of the rows rise from run to run: they tell the same story.
TEST(OutlierGroups, AreNoneWhereASensorStepsWhichIsALaw) {
  SKIP_UNDER_SANITIZERS();
  const MeasuredData data = planted_runs({}, quiet_seed);
  const double step_N = -6;
  const DiagnosisResult result = diagnosed_far(
      with_fault(data, later_half(data), [&](double t, std::size_t) { return t + step_N; }));
  EXPECT_EQ(result.verdict, Verdict::indistinguishable);
  ASSERT_EQ(result.causes.size(), 1U);
  ASSERT_EQ(result.indistinguishable.size(), 1U);
  for (const std::string& name : result.indistinguishable[0]) {
    EXPECT_TRUE(name.starts_with("law[offset of T2, ") && name.ends_with(", step]")) << name;
  }
  EXPECT_EQ(std::count(result.indistinguishable[0].begin(), result.indistinguishable[0].end(),
                       "law[offset of T2, run, step]"),
            1);
  EXPECT_NEAR(result.causes[0].effect.values[0], step_N, 0.05);
  EXPECT_EQ(count_notes(result.notes, NoteKind::outlier_groups), 0U);
}

// Its readings say nothing of the rig.
TEST(OutlierGroups, AreNoneWhereASensorSticksFromARunOn) {
  const MeasuredData data = planted_runs({}, quiet_seed);
  MeasuredData stuck = with_fault(data, later_half(data), [&](double, std::size_t) { return 4.3; });
  readings::leave_out_stuck_channels(stuck);
  EXPECT_EQ(count_notes(stuck.notes, NoteKind::stuck_channel), later_half(data).size());
  const DiagnosisResult result = diagnosed_far(stuck);
  EXPECT_EQ(result.verdict, Verdict::none);
  EXPECT_EQ(count_notes(result.notes, NoteKind::outlier_groups), 0U);
}

// More of small loads, less of great ones.
TEST(OutlierGroups, IsASensorThatSticksNowAndThen) {
  SKIP_UNDER_SANITIZERS();
  const MeasuredData data = planted_runs({}, quiet_seed);
  const Runs runs{1, 5, 9};
  const DiagnosisResult result =
      diagnosed_far(with_fault(data, runs, [](double, std::size_t) { return 4.3; }));
  EXPECT_EQ(result.verdict, Verdict::unexplained);
  ASSERT_EQ(count_notes(result.notes, NoteKind::outlier_groups), 1U);
  const std::string text = note_text(result.notes, NoteKind::outlier_groups);
  EXPECT_TRUE(has(text, "readings of T2 in "));
  EXPECT_TRUE(has(text, "Noise chooses no channel"));
  std::set<std::string> names;
  for (const std::size_t run : runs) names.insert(data.runs[run]);
  // A run may also follow a law of its own.
  std::set<std::string> found =
      runs_of_lines(data, noted_lines(result.notes, NoteKind::outlier_groups));
  for (const RunsApart& apart : result.apart) found.insert(apart.runs.begin(), apart.runs.end());
  EXPECT_EQ(found, names);
}

TEST(OutlierGroups, AreTwoExchangedPlugsInARun) {
  SKIP_UNDER_SANITIZERS();
  MeasuredData data = planted_runs({}, quiet_seed);
  for (Reading& reading : data.readings) {
    if (reading.run == 5) std::swap(reading.tension_N[0], reading.tension_N[2]);
  }
  const DiagnosisResult result = diagnosed_far(data);
  const std::string text = note_text(result.notes, NoteKind::outlier_groups);
  EXPECT_TRUE(has(text, "readings of T1 and T3 in run 6"));
  EXPECT_TRUE(has(text, "are they exchanged there?"));
}

// As those of others do, but twenty times as far.
TEST(OutlierGroups, IsASensorThatScattersMoreAndNothingToExplain) {
  const MeasuredData data = planted_runs({}, quiet_seed);
  Runs all;
  for (std::size_t run = 0; run < data.runs.size(); ++run) all.insert(run);
  const DiagnosisResult result =
      diagnosed_far(with_fault(data, all, [](double tension_N, std::size_t index) {
        return tension_N * std::exp(0.3 * normal(5, 0x4a, index));
      }));
  EXPECT_FALSE(result.unexplained && result.unexplained->about == "channel and run");
  const std::string text = note_text(result.notes, NoteKind::outlier_groups);
  EXPECT_TRUE(has(text, "readings of T2 in all runs"));
  EXPECT_TRUE(has(text, "give its noise"));
}

TEST(OutlierGroups, AreNoneByHeavyTailsAndMountings) {
  SKIP_UNDER_SANITIZERS();
  for (std::uint64_t seed = 3; seed <= 4; ++seed) {
    PlantingPlan plan;
    plan.runs = 8;
    plan.noise.tail_degrees = seed % 2 == 0 ? 3 : 0;
    plan.noise.mounted_exponent = seed % 4 < 2 ? 0.08 : 0.03;
    plan.noise.mounted_gain = seed % 3 == 0 ? 0.01 : 0;
    const DiagnosisResult result = diagnosed_far(planted_runs(plan, seed));
    EXPECT_EQ(note_text(result.notes, NoteKind::outlier_groups), "") << seed;
  }
}

TEST(OutlierGroups, KeepToNothingWhereOthersAreFarToo) {
  EXPECT_TRUE(keep_to_something({{}, 5, 100}));
  EXPECT_FALSE(keep_to_something({{}, 6, 100}));
  EXPECT_TRUE(keep_to_something({}));
}

JudgedCell outlier_cell(std::size_t reading, double expected_N, double z) {
  return {reading, 0, 0, expected_N, z};
}

TEST(OutlierSides, AreEvenForNoise) {
  std::vector<JudgedCell> far;
  for (std::size_t i = 0; i < 12; ++i) {
    far.push_back(outlier_cell(i, 10.0 + static_cast<double>(i), i % 2 == 0 ? 9 : -9));
  }
  const OutlierSides sides = outlier_sides(far);
  EXPECT_EQ(sides.above, 6U);
  EXPECT_EQ(sides.below, 6U);
  EXPECT_GT(sides.p_value, 0.5);
}

TEST(OutlierSides, AreOneSidedForAZeroThatMoved) {
  std::vector<JudgedCell> far;
  for (std::size_t i = 0; i < 12; ++i) far.push_back(outlier_cell(i, 10, 9));
  // Twelve of twelve by the sign test, two-sided, and two tests.
  EXPECT_NEAR(outlier_sides(far).p_value, 2 * 2 * std::pow(0.5, 12), 1e-9);
}

TEST(OutlierSides, ChangeWithTheLoadWhereASensorSticks) {
  std::vector<JudgedCell> far;
  for (std::size_t i = 0; i < 12; ++i) {
    const double load_N = static_cast<double>(i * 5 % 12);
    far.push_back(outlier_cell(i, load_N, load_N < 6 ? 9 : -9));
  }
  // The six lowest ranks of twelve: 18 below the mean, of a deviation of √39.
  EXPECT_NEAR(outlier_sides(far).p_value, 2 * std::erfc(18 / std::sqrt(39.0) / std::sqrt(2.0)),
              1e-9);
}

// Six readings of one row are one row.
TEST(OutlierSides, CountEachRowOnce) {
  std::vector<JudgedCell> far;
  for (std::size_t i = 0; i < 12; ++i) far.push_back(outlier_cell(i / 6, 10, 9));
  const OutlierSides sides = outlier_sides(far);
  EXPECT_EQ(sides.above, 12U);
  EXPECT_DOUBLE_EQ(sides.p_value, 1);
}

}  // namespace
}  // namespace reeve::testing
