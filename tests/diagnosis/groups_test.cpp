// Rows in groups, such as winches, that differ in what pulls or in who reads. The truth is planted
// by code that shares nothing with the causes (tests/support/planting.hpp): the rows of each run
// are taken from the file of its own group's rig.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "diagnosis/diagnose.hpp"
#include "numerics/random.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/planting.hpp"
#include "tests/support/sanitizers.hpp"

namespace reeve::testing {
namespace {

struct Winch {
  double sheath_mu = 0.18;
  NoiseLevel noise = low_noise;
};

std::string measured_by(const Winch& rig, const Experiment& experiment) {
  std::vector<PlantedEffect> effects;
  if (rig.sheath_mu != Winch{}.sheath_mu) {
    effects.push_back(one_number(EffectKind::sheath_friction, "mu", rig.sheath_mu,
                                 [](Truth& truth) -> double& { return truth.nature.sheath_mu; }));
  }
  return measure(experiment, effects, rig.noise, 5).csv;
}

// Runs take turns between winches A and B.
MeasuredData by_winch(const Winch& a, const Winch& b, std::uint64_t seed) {
  Dice dice(seed);
  ExperimentNeeds needs;
  needs.runs = 8;
  const Experiment experiment = random_experiment(needs, dice);
  std::istringstream of_a(measured_by(a, experiment)), of_b(measured_by(b, experiment));
  std::string text, line_a, line_b, last;
  bool header = true, first = false;
  while (std::getline(of_a, line_a) && std::getline(of_b, line_b)) {
    if (line_a.starts_with('#')) continue;
    if (header) {
      text += line_a + ",winch\n";
      header = false;
      continue;
    }
    const std::string run = line_a.substr(0, line_a.find(','));
    if (run != last) first = !first;
    last = run;
    text += first ? line_a + ",A\n" : line_b + ",B\n";
  }
  ReadingOptions options;
  options.group = "winch";
  return read_data(text, options);
}

DiagnosisResult diagnosed_by_winch(const MeasuredData& data) {
  DiagnoseOptions options;
  options.replicates = 400;
  return diagnose(data, Hardware{}, options);
}

const EstimatesByGroup* sheaths_by_group(const DiagnosisResult& result) {
  for (const EstimatesByGroup& of : result.by_group) {
    if (of.cause == "sheath_friction") return &of;
  }
  return nullptr;
}

void expect_one_cause(const DiagnosisResult& result, const std::string& name, double size) {
  EXPECT_EQ(result.verdict, Verdict::cause);
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes.front().name, name);
  EXPECT_NEAR(result.causes.front().effect.values.front(), size, 0.01);
}

TEST(Groups, HaveCoefficientsOfTheirOwn) {
  const DiagnosisResult result = diagnosed_by_winch(by_winch({0.18}, {0.12}, 611));
  expect_one_cause(result, "law[exponent of sheath in group B]", 0.12 / 0.18 - 1);
  const EstimatesByGroup* sheaths = sheaths_by_group(result);
  ASSERT_NE(sheaths, nullptr);
  EXPECT_TRUE(sheaths->differs);
  ASSERT_EQ(sheaths->groups.size(), 2U);
  const std::array truth{0.18, 0.12};
  for (std::size_t g = 0; g < truth.size(); ++g) {
    EXPECT_EQ(sheaths->groups[g].group, g);
    EXPECT_NEAR(sheaths->groups[g].value, truth[g], 0.015);
    EXPECT_LE(sheaths->groups[g].interval.low, truth[g]);
    EXPECT_GE(sheaths->groups[g].interval.high, truth[g]);
  }
}

TEST(Groups, ThatAreAlikeShowNoDifference) {
  const MeasuredData data = by_winch({}, {}, 612);
  const DiagnosisResult result = diagnosed_by_winch(data);
  EXPECT_EQ(result.verdict, Verdict::none);
  EXPECT_TRUE(result.noise.of_group.empty());
  EXPECT_FALSE(result.by_group.empty());
  for (const EstimatesByGroup& of : result.by_group) EXPECT_FALSE(of.differs) << of.cause;
}

// No coefficient differs, but a sensor does.
TEST(Groups, MayDifferByWhatNoCoefficientSays) {
  MeasuredData data = by_winch({}, {}, 612);
  for (Reading& reading : data.readings) {
    if (reading.group == 1U && reading.tension_N[1]) *reading.tension_N[1] *= 0.9;
  }
  const DiagnosisResult result = diagnosed_by_winch(data);
  expect_one_cause(result, "law[gain of T2 in group B]", -0.1);
}

// Each condition is measured twice.
TEST(Groups, HaveScatterOfTheirOwn) {
  constexpr double quiet = 0.01, loud = 0.05;
  std::string text = "run,routing,winch,motor_tension_N,T1_N\n";
  for (std::uint64_t i = 0; i < 400; ++i) {
    const bool is_loud = i / 20 % 2 == 1;
    const double motor = 10 + 0.1 * static_cast<double>(i / 2);
    const double reading = motor / 2 * (1 + (is_loud ? loud : quiet) * normal(9, 5, i));
    text += fmt::format("{},TR3,{},{},{}\n", i / 20, is_loud ? "B" : "A", motor, reading);
  }
  ReadingOptions options;
  options.group = "winch";
  const MeasuredData data = read_data(text, options);
  const auto noise = noise_without_model(all_of(data));
  ASSERT_TRUE(noise.has_value());
  ASSERT_EQ(noise->of_group.size(), 2U);
  // 100 pairs of each: 7 %.
  EXPECT_NEAR(noise->of_group[0] * noise->deviation(10), 10 * quiet, 0.2 * 10 * quiet);
  EXPECT_NEAR(noise->of_group[1] * noise->deviation(10), 10 * loud, 0.2 * 10 * loud);
}

// A reading of the loud winch that is as far out as its noise takes it is none that stands out.
TEST(Groups, WeighByTheirScatter) {
  const MeasuredData data = by_winch({}, {}, 614);
  const Dataset all = all_of(data);
  Noise noise;
  noise.absolute_N = 0.1;
  noise.of_group = {1, 5};
  const Eigen::VectorXd expected =
      Eigen::VectorXd::Constant(static_cast<Eigen::Index>(all.cells.size()), 10);
  const Eigen::VectorXd sd = deviations(all, noise, expected);
  for (std::size_t i = 0; i < all.cells.size(); ++i) {
    const bool loud = data.readings[all.cells[i].reading].group == 1U;
    const double off = std::abs(all.cells[i].measured_N - 10) / (loud ? 0.5 : 0.1);
    if (off > 5) continue;  // weighed at the reading, which is the same here
    EXPECT_DOUBLE_EQ(sd[static_cast<Eigen::Index>(i)], loud ? 0.5 : 0.1);
  }
}

// The files of two rigs, one below the other.
TEST(Groups, WithOneRunNameAreSeparateRuns) {
  ReadingOptions options;
  options.group = "winch";
  const MeasuredData data = read_data(
      "run,routing,winch,T1_N,T2_N\n1,M-1-F,left,2,1\n2,M-1-F,left,2,1\n1,M-1-F,right,2,1\n"
      "1,M-1-F,,2,1\n3,M-1-F,right,2,1\n3,M-1-F,,2,1\n",
      options);
  EXPECT_EQ(data.runs,
            (std::vector<std::string>{"1 (no group)", "1 (left)", "1 (right)", "2", "3"}));
  std::vector<std::size_t> runs;
  for (const Reading& reading : data.readings) runs.push_back(reading.run);
  EXPECT_EQ(runs, (std::vector<std::size_t>{1, 3, 2, 0, 4, 4}));
  ASSERT_FALSE(data.notes.empty());
  EXPECT_EQ(data.notes.front().kind, NoteKind::runs_of_groups);
}

// One rig after the other, what differs between them looks like a drift of whatever it can.
TEST(Groups, AreNoDriftThoughOneFollowsTheOther) {
  SKIP_UNDER_SANITIZERS();
  MeasuredData data = by_winch({0.18}, {0.12}, 611);
  std::stable_sort(data.readings.begin(), data.readings.end(),
                   [](const Reading& a, const Reading& b) { return a.group < b.group; });
  expect_one_cause(diagnosed_by_winch(data), "law[exponent of sheath in group B]", 0.12 / 0.18 - 1);
}

// Half of A's runs are called C: B stands out from both.
TEST(Groups, AreComparedWithAllOthersTogether) {
  SKIP_UNDER_SANITIZERS();
  MeasuredData three = by_winch({0.18}, {0.12}, 611);
  three.groups = {"A", "B", "C"};
  for (Reading& reading : three.readings) {
    if (reading.group == 0U && reading.run % 4 == 0) reading.group = 2;
  }
  const DiagnosisResult result = diagnosed_by_winch(three);
  const EstimatesByGroup* sheaths = sheaths_by_group(result);
  ASSERT_NE(sheaths, nullptr);
  EXPECT_EQ(sheaths->groups.size(), 3U);
  EXPECT_EQ(sheaths->farthest, 1U);
  expect_one_cause(result, "law[exponent of sheath in group B]", 0.12 / 0.18 - 1);
}

// Nobody may think that groups were compared where there is nothing to compare.
TEST(Groups, TooFewOrMissingAreNoted) {
  const auto noted = [](const std::string& rows) {
    ReadingOptions options;
    options.group = "winch";
    std::vector<std::string> texts;
    for (const DataNote& note : read_data("run,routing,winch,T1_N\n" + rows, options).notes) {
      if (note.kind == NoteKind::not_compared) texts.push_back(note.text);
    }
    return texts;
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(noted("1,M-1-F,A,1\n2,M-1-F,B,1\n"), Texts{});
  EXPECT_EQ(noted("1,M-1-F,A,1\n2,M-1-F,B,1\n3,M-1-F,,1\n"),
            Texts{"1 row has no group, and no part in comparisons between groups"});
  EXPECT_EQ(noted("1,M-1-F,A,1\n2,M-1-F,A,1\n"),
            Texts{"all rows are of one group, 'A': there is no other to compare it with"});
  EXPECT_EQ(noted("1,M-1-F,,1\n"), Texts{"the column of groups is empty"});
}

}  // namespace
}  // namespace reeve::testing
