#include "diagnosis/verdict/left_out.hpp"

#include <gtest/gtest.h>

#include "tests/diagnosis/gain_bench.hpp"

namespace reeve::testing {
namespace {

const Noise noise_of_bench{0, bench_deviation_N, NoiseSource::residuals, 10};

std::vector<LeftOutRun> left_out(const MeasuredData& data, const Model& model) {
  Workers workers(2);
  return left_out_runs(data, all_readings(data), model, noise_of_bench, workers);
}

TEST(LeftOutRuns, AreForecastByAFitToTheOthers) {
  const std::vector<BenchReading> readings{
      {"a", 10, 11.1}, {"b", 15, 16.4}, {"b", 25, 27.2}, {"c", 12, 13.9}, {"c", 30, 34.1}};
  const auto runs = left_out(bench_data(readings), with_gain(1.1));
  ASSERT_EQ(runs.size(), 3U);
  std::size_t next = 0;
  for (const LeftOutRun& run : runs) {
    const std::string name = readings[next].run;
    const double gain = gain_without(readings, name);
    EXPECT_NEAR(run.model.effects.front().values.front(), gain, 1e-4) << name;
    ASSERT_EQ(run.cells.size(), run.forecast_N.size());
    for (const double forecast : run.forecast_N) {
      EXPECT_NEAR(forecast, gain * readings[next].motor_tension_N, 1e-2) << name;
      EXPECT_EQ(readings[next++].run, name);
    }
  }
  EXPECT_EQ(next, readings.size());
}

TEST(LeftOutRuns, SayNothingOfAParameterThatOnlyTheRunLeftOutKnows) {
  const MeasuredData data = read_data(
      "run,routing,motor_tension_N,T1_N,Ta_N\na,M-1-F,10,,10\nb,M-1-F,20,,20\nc,M-1-F,30,,30\n"
      "d,M-1-F,10,13,10\n");
  const auto runs = left_out(data, with_gain(1.3));
  ASSERT_EQ(runs.size(), 4U);
  EXPECT_NEAR(runs[0].model.effects.front().values.front(), 1.3, 1e-4);
  EXPECT_NEAR(runs[3].model.effects.front().values.front(), 1, 1e-9);
}

TEST(LeftOutRuns, NeedAParameterAndThreeRuns) {
  const std::vector<BenchReading> readings{{"a", 10, 11.1}, {"b", 15, 16.4}};
  EXPECT_TRUE(left_out(bench_data(readings), with_gain(1.1)).empty());
  const std::vector<BenchReading> more{{"a", 10, 11.1}, {"b", 15, 16.4}, {"c", 12, 13.3}};
  EXPECT_TRUE(left_out(bench_data(more), bench_model()).empty());
  EXPECT_EQ(left_out(bench_data(more), with_gain(1.1)).size(), 3U);
}

TEST(LeftOutRuns, AreAtMostForty) {
  std::vector<BenchReading> readings;
  for (int run = 0; run < 40; ++run) readings.push_back({std::to_string(run), 10.0 + run, 11});
  EXPECT_EQ(left_out(bench_data(readings), with_gain(1.1)).size(), 40U);
  readings.push_back({"40", 60, 66});
  EXPECT_TRUE(left_out(bench_data(readings), with_gain(1.1)).empty());
}

}  // namespace
}  // namespace reeve::testing
