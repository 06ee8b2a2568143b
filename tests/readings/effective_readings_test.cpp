#include "readings/log/effective_readings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "numerics/student_t.hpp"
#include "readings/log/steady_reading.hpp"
#include "tests/support/rig_log.hpp"

namespace reeve::testing {
namespace {

void take_off_a_line(std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const auto time = [&](std::size_t i) { return static_cast<double>(i) - (count - 1) / 2; };
  double mean = 0;
  double slope = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    mean += values[i] / count;
    slope += values[i] * time(i) * 12 / (count * (count * count - 1));
  }
  for (std::size_t i = 0; i < values.size(); ++i) values[i] -= mean + slope * time(i);
}

std::vector<std::vector<double>> stretches(std::size_t count, std::size_t samples,
                                           double correlation) {
  std::vector<std::vector<double>> result;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double> noise =
        correlated_noise(samples, correlation, 11, static_cast<std::uint32_t>(i));
    take_off_a_line(noise);
    result.push_back(std::move(noise));
  }
  return result;
}

// τ = (1 + ρ) / (1 - ρ) for noise of ρ, ρ², …
TEST(CorrelationTime, IsThatOfTheNoise) {
  EXPECT_NEAR(correlation_time(stretches(40, 500, 0)), 1, 0.06);
  EXPECT_NEAR(correlation_time(stretches(40, 500, 0.5)), 3, 0.2);
  EXPECT_NEAR(correlation_time(stretches(40, 500, 0.9)), 19, 2);
}

// Without what the fit has taken, short stretches would seem to be worth far more.
TEST(CorrelationTime, IsToldByManyShortStretchesTogether) {
  EXPECT_NEAR(correlation_time(stretches(400, 90, 0.8)), 9, 1.5);
}

TEST(CorrelationTime, IsOneSampleAtLeast) {
  std::vector<double> swings;
  for (int i = 0; i < 100; ++i) swings.push_back(i % 2 == 0 ? 1 : -1);
  EXPECT_EQ(correlation_time({swings}), 1);
  EXPECT_EQ(correlation_time({{0, 0, 0, 0, 0}}), 1);
  EXPECT_EQ(correlation_time({}), 1);
}

TEST(CorrelationTime, DoesNotDependOnTheScaleOfAStretch) {
  std::vector<std::vector<double>> noise = stretches(20, 200, 0.7);
  const double time = correlation_time(noise);
  for (double& value : noise[3]) value *= 1000;
  EXPECT_NEAR(correlation_time(noise), time, 1e-9 * time);
}

TEST(DeviationOfSamples, IsThatOfTheNoiseWhereALineWasTakenOff) {
  double variance = 0;
  const auto noise = stretches(400, 90, 0.8);
  for (const std::vector<double>& stretch : noise) {
    variance += std::pow(deviation_of_samples(stretch, 9), 2) / 400;
  }
  EXPECT_NEAR(std::sqrt(variance), 1, 0.03);
}

// One level in each of 200 recordings, all of a true tension of 10 N.
LoggedSeries plateaus(double correlation) {
  LoggedSeries series;
  series.tensions_N = {{"T1_N", {}}};
  series.labels.emplace_back();
  for (std::uint32_t i = 0; i < 200; ++i) {
    for (const double value : correlated_noise(300, correlation, 5, i)) {
      series.lines.push_back(series.size() + 2);
      series.tensions_N[0].values.push_back(10 + 0.2 * value);
      series.time_s.push_back(0.01 * static_cast<double>(series.size()));
      series.label.push_back(0);
    }
  }
  return series;
}

double coverage(double correlation) {
  const LoggedSeries series = plateaus(correlation);
  std::vector<SampleUse> uses(series.size());
  std::vector<AveragedStretch> averaged;
  for (std::size_t i = 0; i < 200; ++i) {
    averaged.push_back(*average(series, 300 * i, 300 * (i + 1), 0.02, uses));
  }
  int held = 0;
  for (const SteadyReading& reading : with_scatter(averaged)) {
    const AveragedTension& tension = *reading.tensions_N[0];
    const auto readings = static_cast<double>(reading.readings);
    const double error_N = tension.deviation_N / std::sqrt(readings);
    held += std::abs(tension.mean_N - 10) <= student_t_quantile(0.975, readings - 2) * error_N;
  }
  return held / 200.0;
}

// 0.95 ± two standard deviations of 200 trials.
TEST(StandardErrorOfAReading, HoldsInNinetyFivePercentOfPlateaus) {
  EXPECT_NEAR(coverage(0), 0.95, 0.031);
  EXPECT_NEAR(coverage(0.5), 0.95, 0.031);
  EXPECT_NEAR(coverage(0.9), 0.95, 0.031);
}

}  // namespace
}  // namespace reeve::testing
