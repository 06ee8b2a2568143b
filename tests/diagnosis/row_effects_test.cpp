// Rows that differ by their place in the run, by the step to which their motor
// tension is known, by zeros that each run has, and by what one channel reads
// of another: readings of TR1 by the paper's equations, or planted ones. Noise
// is drawn here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "diagnosis/diagnose.hpp"
#include "diagnosis/fit/evidence.hpp"
#include "diagnosis/fit/scatter_samples.hpp"
#include "numerics/random.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/planting.hpp"

namespace reeve::testing {
namespace {

using PullOfRow = std::function<double(double recorded_N, int row)>;

// 12 runs of 10 rows. `pulls` is what the motor pulls with, `writes` what the
// file says of that.
std::string rows_csv(const PullOfRow& pulls, const std::function<double(double)>& writes) {
  const double phi_sheath = 0.18 * 2 * std::numbers::pi;
  const double phi_tube = 0.18 * std::numbers::pi;
  std::string text = "run,routing,held,motor_tension_N,T1_N,T2_N,T3_N,T4_N\n";
  std::uint64_t drawn = 0;
  for (int run = 1; run <= 12; ++run) {
    for (int row = 1; row <= 10; ++row) {
      const double motor_N = 8 + 30 * uniform(1, 2, drawn);
      text += fmt::format("r{},M-1-T-2-F,1,{}", run, writes(motor_N));
      double tension_N = pulls(motor_N, row) * std::exp(-phi_sheath);
      for (int strand = 0; strand < 4; ++strand) {
        text += fmt::format(",{:.5f}", tension_N * (1 + 0.005 * normal(1, 4, drawn++)));
        tension_N *= std::exp(-phi_tube);
      }
      text += "\n";
    }
  }
  return text;
}

double as_it_is(double motor_N) { return motor_N; }

// The tendon creeps after each mounting: the motor's pull falls by 1.5 N.
TEST(RowInRun, IsFollowedByATendonThatCreepsInEachRun) {
  const auto creeps = [](double motor_N, int row) {
    return motor_N - 1.5 * (1 - std::exp(-row / 3.0));
  };
  const DiagnosisResult result = diagnose(read_data(rows_csv(creeps, as_it_is)), {}, {});
  ASSERT_FALSE(result.causes.empty());
  EXPECT_EQ(result.causes.front().name.find("law[offset of motor, row_in_run, "), 0U)
      << result.causes.front().name;
  EXPECT_LT(result.residual_after_N, 0.2 * result.residual_before_N);
}

// A break of fifteen minutes in each run lets the grease of the sheath set
// again.
TEST(SincePause, IsFollowedByFrictionThatFallsAgainAfterEachPause) {
  std::string text = "run,routing,held,motor_tension_N,time_s,T1_N,T2_N,T3_N,T4_N\n";
  std::uint64_t drawn = 0;
  for (int run = 1; run <= 12; ++run) {
    for (int row = 0; row < 14; ++row) {
      const double motor_N = 8 + 30 * uniform(1, 2, drawn);
      const double since_s = 40 * (row < 7 ? row : row - 7);
      text += fmt::format("r{},M-1-T-2-F,1,{},{}", run, motor_N, 40 * row + (row < 7 ? 0 : 900));
      const double more = 1 + 0.4 * std::exp(-since_s / 100);
      double tension_N = motor_N * std::exp(-0.18 * 2 * std::numbers::pi * more);
      for (int strand = 0; strand < 4; ++strand) {
        text += fmt::format(",{:.5f}", tension_N * (1 + 0.005 * normal(1, 4, drawn++)));
        tension_N *= std::exp(-0.18 * std::numbers::pi);
      }
      text += "\n";
    }
  }
  const DiagnosisResult result = diagnose(read_data(text), {}, {});
  ASSERT_FALSE(result.causes.empty());
  const auto follows = std::ranges::find_if(result.causes, [](const NamedCause& cause) {
    return cause.name.find("since_pause_s") != std::string::npos;
  });
  ASSERT_NE(follows, result.causes.end());
  const causes::Term& law = *causes::term_of(*follows->effect.cause);
  EXPECT_EQ(law.target, causes::Target::exponent);
  EXPECT_EQ(law.x.seen.high, 240);
  EXPECT_LT(result.residual_after_N, 0.2 * result.residual_before_N);
}

Likelihood nominal_likelihood(const MeasuredData& data) {
  const Dataset dataset = all_of(data);
  Workers workers(1);
  const Model nominal;
  const ScatterShape shape = scatter_shape(dataset, nominal, std::nullopt, workers);
  EXPECT_NEAR(shape.rounded_N, 2 / std::sqrt(12.0), 1e-9);
  return likelihood(dataset, shape, forecast(dataset, nominal));
}

TEST(RoundedMotorTension, ScattersByItsStep) {
  const auto pulls = [](double motor_N, int) { return motor_N; };
  const auto to_2_N = [](double motor_N) { return 2 * std::round(motor_N / 2); };
  EXPECT_TRUE(nominal_likelihood(read_data(rows_csv(pulls, to_2_N))).level.rounded);
}

// The motor was set to these values.
TEST(RoundedMotorTension, IsExactIfItWasSetSo) {
  const auto pulls = [](double motor_N, int) { return 2 * std::round(motor_N / 2); };
  const auto to_2_N = [](double motor_N) { return 2 * std::round(motor_N / 2); };
  EXPECT_FALSE(nominal_likelihood(read_data(rows_csv(pulls, to_2_N))).level.rounded);
}

// Each channel is tared anew for each run.
TEST(ZerosOfRuns, ScatterAndAreNoCause) {
  constexpr double deviation_N = 0.1;
  MeasuredData data = read_data(rows_csv([](double motor_N, int) { return motor_N; }, as_it_is));
  for (Reading& reading : data.readings) {
    for (std::size_t c = 0; c < reading.tension_N.size(); ++c) {
      *reading.tension_N[c] += deviation_N * normal(2, 9, 10 * reading.run + c);
    }
  }
  const DiagnosisResult result = diagnose(data, {}, {});
  EXPECT_EQ(result.verdict, Verdict::none);
  const auto zero = static_cast<std::size_t>(Mounted::zero);
  EXPECT_GE(result.mounting.told_by[zero], 12);
  const double found_N = result.mounting.relative[zero] * median_reading(all_of(data));
  // 48 zeros determine their standard deviation to some 10 %.
  EXPECT_NEAR(found_N, deviation_N, 0.3 * deviation_N);
}

TEST(Channel, ReadsAPartOfAnotherOne) {
  constexpr double part = 0.08;
  MeasuredData data = read_data(plant({}, 81).csv);
  for (Reading& reading : data.readings) {
    if (reading.tension_N[1] && reading.tension_N[2]) {
      *reading.tension_N[1] += part * *reading.tension_N[2];
    }
  }
  const DiagnosisResult result = diagnose(data, {}, {});
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes[0].name, "law[offset of T2, T3, linear]");
  EXPECT_NEAR(result.causes[0].effect.values[0], part, 0.01);
}

}  // namespace
}  // namespace reeve::testing
