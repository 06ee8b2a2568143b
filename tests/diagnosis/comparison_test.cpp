#include "diagnosis/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/diagnosis/read_dataset.hpp"

namespace reeve {
namespace {

using testing::input_error;
using testing::noted_lines;
using testing::read_data;

using Lines = std::vector<std::size_t>;

const double past_tube = std::exp(-0.18 * std::numbers::pi);
const double past_sheath = std::exp(-0.18 * 2 * std::numbers::pi);

Comparison compared(const std::string& text) { return compare(read_data(text), Model{}); }

std::vector<double> predicted(const std::string& text) {
  std::vector<double> values;
  for (const ComparedValue& value : compared(text).values) values.push_back(value.predicted);
  return values;
}

void expect_near(const std::vector<double>& actual, const std::vector<double>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(actual[i], expected[i], 1e-9) << i;
}

TEST(Comparison, PredictsTensionsAtTheMotorTensionOfTheRow) {
  expect_near(predicted("run,routing,motor_tension_N,T1_N,T2_N,Ta_N,T4_N\n"
                        "A,M-1-T-2-F,10,1,1,1,1\nA,M-1-T-2-F,20,,1,,\n"),
              {10 * past_sheath, 10 * past_sheath * past_tube, 10,
               10 * past_sheath * past_tube * past_tube * past_tube, 20 * past_sheath * past_tube});
}

TEST(Comparison, PredictsReleasing) {
  expect_near(predicted("run,routing,direction,motor_tension_N,T1_N,T2_N\n"
                        "A,M-1-F,release,10,1,1\n"),
              {10 / past_sheath, 10 / past_sheath / past_tube});
}

TEST(Comparison, PredictsABenchOfOneSheath) {
  expect_near(predicted("run,routing,motor_tension_N,Ta_N,Th1_N\nA,M-F,10,10,3\n"),
              {10, 10 * past_sheath});
}

// TR5 with finger 1 held: T4 is what friction leaves behind; with none held all strands are alike.
TEST(Comparison, PredictsTheGraspOfTheRow) {
  const auto values =
      predicted("run,routing,held,motor_tension_N,T1_N,T4_N\nA,TR5,,1,1,1\nA,TR5,1,1,1,1\n");
  ASSERT_EQ(values.size(), 4U);
  EXPECT_NEAR(values[0], values[1], 1e-9);
  EXPECT_GT(values[2], 10 * values[3]);
}

TEST(Comparison, TakesTheSheathAngleOfTheRow) {
  const std::string header = "run,routing,motor_tension_N,sheath_angle_rad,T1_N\n";
  expect_near(predicted(header + "A,M-1-F,10,0,1\nA,M-1-F,10,5,1\nA,M-1-F,10,,1\n"),
              {10, 10 * std::exp(-0.18 * 5), 10 * past_sheath});
  Hardware hardware;
  hardware.fingers.emplace_back();
  hardware.fingers[0].finger = 1;
  hardware.fingers[0].sheath_mu = 0.1;
  hardware.fingers[0].sheath_angle_rad = 9.0;
  EXPECT_NEAR(compare(read_data(header + "A,M-1-F,10,5,1\n"), Model{hardware}).values[0].predicted,
              10 * std::exp(-0.1 * 5), 1e-9);
  hardware.contacts.push_back({"T1", "a", 0.05, 8.0});
  hardware.contacts.push_back({"T1", "T2", 0.05, 8.0});
  const auto values =
      compare(
          read_data("run,routing,motor_tension_N,sheath_angle_rad,T1_N,T2_N\nA,M-1-F,10,5,1,1\n"),
          Model{hardware})
          .values;
  EXPECT_NEAR(values[0].predicted, 10 * std::exp(-0.05 * 5), 1e-9);
  EXPECT_NEAR(values[1].predicted, 10 * std::exp(-0.05 * 5 - 0.05 * 8), 1e-9);
}

TEST(Comparison, NamesTheLineWhoseSheathHasTooMuchFriction) {
  Hardware hardware;
  hardware.sheath.mu = 0.5;
  EXPECT_EQ(testing::out_of_range([&] {
              compare(read_data("run,routing,motor_tension_N,sheath_angle_rad,T1_N\n"
                                "A,M-1-F,10,1,1\nA,M-1-F,10,30,1\n"),
                      Model{hardware});
            }),
            "d.csv:3: hardware: sheath: mu * angle = 15: expected at most 10");
}

TEST(ComparisonWithoutMotorTension, IsOfSharesOverTheMeasuredStrands) {
  const Comparison result = compared("run,routing,T1_N,T2_N,T3_N\nA,M-1-T-2-F,6,3,1\n");
  const double sum = 1 + past_tube + past_tube * past_tube;
  ASSERT_EQ(result.values.size(), 3U);
  EXPECT_EQ(result.values[0].quantity, ComparedQuantity::share);
  EXPECT_NEAR(result.values[0].measured, 0.6, 1e-12);
  EXPECT_NEAR(result.values[0].predicted, 1 / sum, 1e-9);
  EXPECT_NEAR(result.values[2].residual(), 0.1 - past_tube * past_tube / sum, 1e-9);
  EXPECT_EQ(result.tension.all.count, 0U);
  EXPECT_EQ(result.share.all.count, 3U);
}

TEST(ComparisonWithoutMotorTension, NotesWhatItLeavesOut) {
  const Comparison result = compared(
      "run,routing,Ta_N,T1_N,T2_N\n"
      "A,M-1-F,5,1,1\n"
      "A,M-1-F,,1,\n"
      "A,M-1-F,,0,0\n");
  ASSERT_EQ(result.values.size(), 2U);
  ASSERT_EQ(result.notes.size(), 3U);
  EXPECT_EQ(result.notes[0].lines, Lines{2});
  EXPECT_EQ(result.notes[1].lines, Lines{3});
  EXPECT_EQ(result.notes[2].lines, Lines{4});
  EXPECT_EQ(input_error([] { compared("run,routing,T1_N\nA,M-1-F,1\n"); }),
            "d.csv: there is nothing to compare: expected rows with motor_tension_N, or with the "
            "tensions of two strands that are not all slack");
}

TEST(Comparison, NotesGraspsThatJam) {
  const Comparison result =
      compared("run,routing,held,motor_tension_N,T1_N\nA,M-1-F,,10,3\nA,M-1-F,1,10,3\n");
  EXPECT_EQ(noted_lines(result.notes, NoteKind::jams), Lines{3});
  EXPECT_EQ(result.values.size(), 2U);
}

// What the file does not say, the model's effects on the sensors and on the friction do.
TEST(Comparison, TakesAModelsEffects) {
  Model model;
  add_effect(model, {find_cause("tube_friction"), {}, {0.1}});
  const MeasuredData data =
      read_data("run,routing,motor_tension_N,T1_N,T2_N\nA,M-1-F,10,3,2\nA,M-1-F,0,3,2\n");
  const auto values = compare(data, model).values;
  ASSERT_EQ(values.size(), 4U);
  EXPECT_NEAR(values[1].predicted / values[0].predicted, std::exp(-0.1 * std::numbers::pi), 1e-9);
  EXPECT_EQ(values[2].predicted, 0);
  EXPECT_EQ(values[2].measured, 3);
}

// Without friction all tensions are the motor's: residuals are easy to see.
TEST(Summaries, AreMeanAndRootMeanSquareOfTheResiduals) {
  Hardware smooth;
  smooth.tube.mu = smooth.sheath.mu = 0;
  const Comparison result =
      compare(read_data("run,routing,held,direction,motor_tension_N,T1_N,T2_N\n"
                        "B,M-1-F,1,pull,10,11,9\n"
                        "A,M-1-F,,release,10,14,\n"
                        "A,M-1-F+M-2-F,,pull,20,10,13\n"),
              Model{smooth});
  const auto expect = [](const ResidualSummary& summary, const std::string& group,
                         std::size_t count, double mean, double residual, double squares) {
    const auto n = static_cast<double>(count);
    EXPECT_EQ(summary.group, group);
    EXPECT_EQ(summary.count, count);
    EXPECT_NEAR(summary.mean_measured, mean, 1e-9);
    EXPECT_NEAR(summary.mean_residual, residual, 1e-9);
    EXPECT_NEAR(summary.rms, std::sqrt(squares / n), 1e-9);
    EXPECT_NEAR(summary.relative_rms, std::sqrt(squares / n) / mean, 1e-9);
  };
  const QuantitySummary& tension = result.tension;
  expect(tension.all, "all", 5, 11.4, 1.4, 1 + 1 + 16 + 0 + 9);
  expect(tension.by_routing[0], "M-1-F", 3, 34.0 / 3, 4.0 / 3, 18);
  expect(tension.by_routing[1], "M-1-F+M-2-F", 2, 11.5, 1.5, 9);
  expect(tension.by_channel[0], "T1", 3, 35.0 / 3, 5.0 / 3, 17);
  expect(tension.by_channel[1], "T2", 2, 11, 1, 10);
  expect(tension.by_grasp[0], "none", 3, 37.0 / 3, 7.0 / 3, 25);
  expect(tension.by_grasp[1], "1", 2, 10, 0, 2);
  expect(tension.by_direction[0], "pull", 4, 10.75, 0.75, 11);
  expect(tension.by_direction[1], "release", 1, 14, 4, 16);
  expect(tension.by_run[0], "B", 2, 10, 0, 2);
  expect(tension.by_run[1], "A", 3, 37.0 / 3, 7.0 / 3, 25);
  EXPECT_EQ(result.share.all.count, 0U);
  EXPECT_TRUE(result.share.by_run.empty());
}

TEST(Summaries, HaveOneForEachGroupWithoutRowsThatHaveNone) {
  Hardware smooth;
  smooth.tube.mu = smooth.sheath.mu = 0;
  ReadingOptions options;
  options.group = "winch";
  const Comparison result = compare(read_data("run,routing,motor_tension_N,winch,T1_N\n"
                                              "A,M-1-F,10,right,11\n"
                                              "A,M-1-F,10,left,14\n"
                                              "A,M-1-F,10,,99\n"
                                              "B,M-1-F,20,right,22\n",
                                              options),
                                    Model{smooth});
  const std::vector<ResidualSummary>& groups = result.tension.by_group;
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].group, "right");
  EXPECT_EQ(groups[0].count, 2U);
  EXPECT_NEAR(groups[0].mean_residual, 1.5, 1e-9);
  EXPECT_EQ(groups[1].group, "left");
  EXPECT_NEAR(groups[1].mean_residual, 4, 1e-9);
  EXPECT_EQ(result.tension.all.count, 4U);
}

TEST(Summaries, HaveNoRelativeErrorWhereAllReadingsAreZero) {
  const Comparison result = compared("run,routing,motor_tension_N,T1_N\nA,M-1-F,10,0\n");
  EXPECT_NEAR(result.tension.all.rms, 10 * past_sheath, 1e-9);
  EXPECT_TRUE(std::isnan(result.tension.all.relative_rms));
}

}  // namespace
}  // namespace reeve
