// Coefficients that are free in every model, on data whose coefficients are known.
#include "diagnosis/search/calibration.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "diagnosis/diagnose.hpp"
#include "numerics/random.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/sanitizers.hpp"

namespace reeve::testing {
namespace {

// M-1-F: motor tension, sheath (2 pi), T1.
std::string sheath_csv(double mu, int runs, double scatter = 0) {
  std::string csv = "run,routing,motor_tension_N,T1_N\n";
  std::uint64_t index = 0;
  for (int run = 0; run < runs; ++run) {
    const double here = mu * (1 + scatter * normal(5, 3, static_cast<std::uint64_t>(run)));
    for (int row = 0; row < 10; ++row) {
      const double motor = 10 + 4 * row;
      const double tension = motor * std::exp(-here * 2 * std::numbers::pi);
      csv +=
          fmt::format("{},M-1-F,{},{}\n", run, motor, tension * (1 + 0.01 * normal(5, 4, index++)));
    }
  }
  return csv;
}

DiagnosisResult diagnosed_sheaths(const std::string& csv, const Hardware& hardware = {},
                                  double alpha = DiagnoseOptions{}.alpha) {
  DiagnoseOptions options;
  options.replicates = 100;
  options.threads = 1;
  options.alpha = alpha;
  return diagnose(read_data(csv), hardware, options);
}

// Among the causes, or those that cannot be told from one.
bool is_named(const DiagnosisResult& result, const std::string& name) {
  const auto has = [&](const auto& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return std::any_of(result.causes.begin(), result.causes.end(),
                     [&](const NamedCause& cause) { return cause.name == name; }) ||
         std::any_of(result.indistinguishable.begin(), result.indistinguishable.end(), has);
}

TEST(Calibration, FindsACoefficientThatDiffersFromTheHardwareFile) {
  const DiagnosisResult result = diagnosed_sheaths(sheath_csv(0.12, 6));
  ASSERT_EQ(result.calibration.size(), 1U);
  EXPECT_EQ(result.calibration[0].name, "sheath_friction");
  EXPECT_TRUE(result.calibration[0].differs);
  EXPECT_NEAR(result.calibration[0].parameter.value, 0.12, 0.003);
  EXPECT_LE(result.calibration[0].parameter.low, 0.12);
  EXPECT_GE(result.calibration[0].parameter.high, 0.12);
}

// By what it says hardly anything would arrive, whatever is changed a little.
TEST(Calibration, FindsTheCoefficientFarFromWhatTheHardwareSays) {
  for (const double guess : {0.5, 1.0, 1.5}) {
    Hardware hardware;
    hardware.sheath.mu = guess;
    const DiagnosisResult result = diagnosed_sheaths(sheath_csv(0.05, 6), hardware);
    ASSERT_EQ(result.calibration.size(), 1U);
    EXPECT_NEAR(result.calibration[0].parameter.value, 0.05, 0.003) << guess;
  }
}

TEST(Calibration, NamesNoCauseWhereTheHardwareFileIsRight) {
  const DiagnosisResult result = diagnosed_sheaths(sheath_csv(0.18, 6));
  ASSERT_EQ(result.calibration.size(), 1U);
  EXPECT_FALSE(result.calibration[0].differs);
  EXPECT_TRUE(result.causes.empty());
}

// Six standard errors from what the hardware says, as twelve runs know them, and less than one.
TEST(Calibration, DiffersWhereChanceSaysSo) {
  const std::string csv = sheath_csv(0.182, 12);
  EXPECT_TRUE(diagnosed_sheaths(csv, {}, 0.01).calibration.at(0).differs);
  EXPECT_FALSE(diagnosed_sheaths(sheath_csv(0.1802, 12), {}, 0.01).calibration.at(0).differs);
}

TEST(Calibration, LeavesAKnownCoefficientAsItIs) {
  Hardware hardware;
  hardware.sheath.known = true;
  const DiagnosisResult result = diagnosed_sheaths(sheath_csv(0.12, 6), hardware);
  EXPECT_TRUE(result.calibration.empty());
  EXPECT_FALSE(is_named(result, "sheath_friction"));
}

TEST(Calibration, LeavesNoFrictionAsItIs) {
  Hardware hardware;
  hardware.sheath.mu = 0;
  EXPECT_TRUE(diagnosed_sheaths(sheath_csv(0, 6), hardware).calibration.empty());
}

TEST(Calibration, OfNoFrictionIsACauseLikeOthers) {
  Hardware hardware;
  hardware.sheath.mu = 0;
  const DiagnosisResult result = diagnosed_sheaths(sheath_csv(0.12, 6), hardware);
  EXPECT_TRUE(result.calibration.empty());
  EXPECT_TRUE(is_named(result, "sheath_friction"));
}

// Five times what there is, where no gain beyond three is searched.
TEST(Calibration, NamesNoSizeAtTheEndOfWhatIsSearched) {
  Hardware hardware;
  hardware.sheath.known = true;
  std::string csv = "run,routing,motor_tension_N,T1_N\n";
  for (int i = 0; i < 60; ++i) {
    const double motor = 10 + i % 10;
    const double tension = 5 * motor * std::exp(-0.18 * 2 * std::numbers::pi);
    csv += fmt::format("{},M-1-F,{},{}\n", i / 10, motor,
                       tension * (1 + 0.01 * normal(5, 6, static_cast<std::uint64_t>(i))));
  }
  const DiagnosisResult result = diagnosed_sheaths(csv, hardware);
  for (const NamedCause& cause : result.causes) {
    for (const EstimatedParameter& parameter : cause.parameters) {
      EXPECT_FALSE(parameter.at_bound) << cause.name;
    }
  }
}

// Runs that differ by 10 % know less than their sixty readings; each mounted again tells by how
// much.
TEST(Calibration, IsAsSureAsTheMountingsAre) {
  const DiagnosisResult result = diagnosed_sheaths(sheath_csv(0.18, 9, 0.1));
  ASSERT_EQ(result.calibration.size(), 1U);
  const EstimatedParameter& mu = result.calibration[0].parameter;
  const double of_readings = 2 * 0.01 / (2 * std::numbers::pi) / std::sqrt(60.0);
  EXPECT_GT(mu.high - mu.low, 10 * of_readings);
  EXPECT_LE(mu.low, 0.18);
  EXPECT_GE(mu.high, 0.18);
  EXPECT_NEAR(result.mounting.relative[0], 0.1, 0.06);
  EXPECT_GT(result.mounting.told_by[0], 3);
}

TEST(Calibration, OfOneMountingAssumesHowTheyDiffer) {
  const DiagnosisResult result = diagnosed_sheaths(sheath_csv(0.18, 1));
  EXPECT_EQ(result.mounting.mounted_again, 0U);
  EXPECT_LT(result.mounting.told_by[0], 1);
  EXPECT_NEAR(result.mounting.relative[0], assumed_scatter[0], 1e-3);
  ASSERT_EQ(result.calibration.size(), 1U);
  const EstimatedParameter& mu = result.calibration[0].parameter;
  EXPECT_GT(mu.high - mu.low, 2 * 1.9 * assumed_scatter[0] * 0.17);
}

// T1 and T3 stand each behind a sheath of its own. With phi = mu theta, a coefficient that is
// greater and a second sheath that bends less say the same as a first sheath that bends more.
std::string csv_of_two_sheaths(double mu, double angle_1, double angle_2) {
  std::string csv = "run,routing,motor_tension_N,T1_N,T3_N\n";
  std::uint64_t index = 0;
  for (int i = 0; i < 400; ++i) {
    const double motor = 10 + 4 * (i % 10);
    const auto reading = [&](double angle) {
      return motor * std::exp(-mu * angle) * (1 + 0.01 * normal(5, 8, index++));
    };
    csv += fmt::format("{},M-1-T-2-F,{},{},\n", i / 40, motor, reading(angle_1));
    csv += fmt::format("{},M-2-T-1-F,{},,{}\n", i / 40, motor, reading(angle_2));
  }
  return csv;
}

TEST(Calibration, OfCausesThatExplainAlikeTheCoefficientDecides) {
  SKIP_UNDER_SANITIZERS();
  constexpr double angle = 2 * std::numbers::pi;
  const std::string csv = csv_of_two_sheaths(0.18, angle + 1, angle);
  const DiagnosisResult as_the_hardware_says = diagnosed_sheaths(csv);
  EXPECT_TRUE(is_named(as_the_hardware_says, "sheath_angle[1]"));
  EXPECT_FALSE(is_named(as_the_hardware_says, "sheath_angle[2]"));
  Hardware guessed;
  guessed.sheath.mu = 0.15;
  const DiagnosisResult as_no_hardware_says = diagnosed_sheaths(csv, guessed);
  EXPECT_TRUE(is_named(as_no_hardware_says, "sheath_angle[1]"));
  EXPECT_TRUE(is_named(as_no_hardware_says, "sheath_angle[2]"));
}

// Worn sheaths and tubes are both rougher, in one proportion.
TEST(Calibration, OneCauseMayStandForSeveralCoefficients) {
  const double phi = 0.18 * 1.3;
  std::string csv = "run,routing,motor_tension_N,cycle,T1_N,T2_N,T3_N,T4_N\n";
  std::uint64_t index = 0;
  for (int i = 0; i < 120; ++i) {
    const double motor = 10 + 4 * (i % 10);
    const std::array<double, 4> angles{2, 3, 4, 5};  // in pi: a sheath, and three tubes
    csv += fmt::format("{},M-1-T-2-F,{},2000", i / 20, motor);
    for (const double half_turns : angles) {
      const double tension = motor * std::exp(-phi * half_turns * std::numbers::pi);
      csv += fmt::format(",{}", tension * (1 + 0.01 * normal(5, 9, index++)));
    }
    csv += "\n";
  }
  const DiagnosisResult result = diagnosed_sheaths(csv);
  EXPECT_EQ(std::count_if(result.calibration.begin(), result.calibration.end(),
                          [](const CalibratedCoefficient& each) { return each.differs; }),
            2);
  EXPECT_EQ(result.verdict, Verdict::indistinguishable);
  EXPECT_TRUE(is_named(result, "wear"));
}

}  // namespace
}  // namespace reeve::testing
