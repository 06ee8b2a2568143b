#include "diagnosis/verdict/left_out.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "tests/diagnosis/gain_bench.hpp"

namespace reeve::testing {
namespace {

const Noise noise_of_bench{0, bench_deviation_N, diagnosis::NoiseSource::residuals, 10};

std::vector<LeftOutRun> left_out(const MeasuredData& data, const Model& model,
                                 const Noise& noise = noise_of_bench) {
  Workers workers(2);
  return left_out_runs(data, all_readings(data), model, {noise, {}}, workers);
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

// g = sum(w T_M T1) / sum(w T_M^2), with the weights of readings that scatter by 0.1 N and 5 % of
// what is forecast.
TEST(LeftOutRuns, AreForecastByAFitThatWeighsByTheNoise) {
  const std::vector<BenchReading> readings{{"a", 2, 2.5}, {"b", 20, 21}, {"c", 5, 5.8}};
  constexpr double gain = 1.1;
  const Noise noise{0.05, bench_deviation_N, diagnosis::NoiseSource::residuals, 10};
  const auto runs = left_out(bench_data(readings), with_gain(gain), noise);
  ASSERT_EQ(runs.size(), 3U);
  for (std::size_t left = 0; left < 3; ++left) {
    double along = 0, square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == left) continue;
      const BenchReading& reading = readings[i];
      const double deviation = std::hypot(bench_deviation_N, 0.05 * gain * reading.motor_tension_N);
      along += reading.motor_tension_N * reading.reading_N / std::pow(deviation, 2);
      square += std::pow(reading.motor_tension_N / deviation, 2);
    }
    EXPECT_NEAR(runs[left].model.effects.front().values.front(), along / square, 1e-4) << left;
  }
}

// T1 = T_M e^(-mu angle): the first three runs say that mu is 0.3, by which the exponent of the
// fourth would be 12, and no contact has more than 10.
TEST(LeftOutRuns, HaveNoForecastWhereTheOthersModelHasNoTensions) {
  const double three_tenths = 10 * std::exp(-0.3 * 5);
  std::string text = "run,routing,motor_tension_N,sheath_angle_rad,T1_N\n";
  for (const char* run : {"a", "b", "c"})
    text += fmt::format("{},M-1-F,10,5,{}\n", run, three_tenths);
  const MeasuredData data = read_data(text + "d,M-1-F,10,40,0.5\n");
  Model model = bench_model();
  add_effect(model, {find_cause("sheath_friction"), {}, {0.1}});
  const auto runs = left_out(data, model);
  ASSERT_EQ(runs.size(), 4U);
  EXPECT_EQ(runs[0].forecast_N.size(), 1U);
  EXPECT_NEAR(runs[3].model.effects.front().values.front(), 0.3, 1e-4);
  EXPECT_TRUE(runs[3].cells.empty());
  EXPECT_TRUE(runs[3].forecast_N.empty());
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

// Run b was mounted with two routings, and its readings stand between those of the others.
TEST(LeftOutRuns, LeaveTheOthersAProblemAsIfTheyWereAlone) {
  const MeasuredData data = read_data(
      "run,routing,motor_tension_N,T1_N,T2_N\na,1-P-2-P-1,10,2.2,4.1\nb,1-P-2-P-1,12,2.4,5\n"
      "b,1-T-2-P-1,20,9,8\na,1-P-2-P-1,30,6.5,12\nc,1-T-2-P-1,20,9.1,8.2\n");
  const Scatter scatter{noise_of_bench, {{0.04, 0.04, 0.1, 0.02}, {}}};
  const Model model{Hardware{}};
  const Dataset all = dataset(data, all_readings(data));
  const Dataset rest = dataset(data, {0, 3, 4});
  Workers workers(1);
  const Problem part = part_of(problem(all, scatter, model, workers), rest);
  const Problem alone = problem(rest, scatter, model, workers);
  EXPECT_EQ(part.dataset, &rest);
  EXPECT_EQ(part.measured_N, alone.measured_N);
  EXPECT_EQ(part.deviation_N, alone.deviation_N);
  EXPECT_EQ(part.shared.size(), 2U);
  const Forecast at = forecast(rest, model);
  EXPECT_LT((residuals(part, at) - residuals(alone, at)).norm(), 1e-9);
  EXPECT_GT((residuals(part, at) - own_residuals(alone, at)).norm(), 0.1);
}

TEST(LeftOutRuns, NeedAParameterAndThreeRuns) {
  const std::vector<BenchReading> readings{{"a", 10, 11.1}, {"b", 15, 16.4}};
  EXPECT_TRUE(left_out(bench_data(readings), with_gain(1.1)).empty());
  const std::vector<BenchReading> more{{"a", 10, 11.1}, {"b", 15, 16.4}, {"c", 12, 13.3}};
  EXPECT_TRUE(left_out(bench_data(more), bench_model()).empty());
  EXPECT_EQ(left_out(bench_data(more), with_gain(1.1)).size(), 3U);
}

TEST(LeftOutRuns, AreNotForecastOnceTheDiagnosisIsStopped) {
  const MeasuredData data = bench_data({{"a", 10, 11.1}, {"b", 15, 16.4}, {"c", 12, 13.3}});
  const std::atomic<bool> stop = true;
  Workers workers(2, &stop);
  EXPECT_THROW(
      left_out_runs(data, all_readings(data), with_gain(1.1), {noise_of_bench, {}}, workers),
      Stopped);
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
