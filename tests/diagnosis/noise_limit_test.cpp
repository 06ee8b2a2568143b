
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "causes/library.hpp"
#include "diagnosis/verdict/held_out.hpp"
#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {
namespace {

constexpr double sd_N = 0.05;
constexpr int row_count = 30;

double truth(double mu, double load, bool beyond_the_tip) {
  return load * std::exp(-0.36 * std::numbers::pi - (beyond_the_tip ? mu * std::numbers::pi : 0));
}

// One finger on one tendon, whose capstan law is written out: the tube has 0.09 instead of 0.18.
MeasuredData readings(std::mt19937& random) {
  std::normal_distribution<double> noise(0, sd_N);
  std::string text = "run,routing,motor_tension_N,T1_N,T2_N\n";
  for (int i = 0; i < row_count; ++i) {
    const double load = 10 + i;
    text += fmt::format("{},M-1-F,{},{},{}\n", i < 10 ? "first" : "second", load,
                        truth(0.09, load, false) + noise(random),
                        truth(0.09, load, true) + noise(random));
  }
  return read_data(text);
}

Model true_model() {
  Model model;
  add_effect(model, {find_cause("tube_friction"), {}, {0.09}});
  return model;
}

TEST(NoiseLimit, IsWhatTheTrueModelGains) {
  std::mt19937 random(7);
  constexpr int experiments = 300;
  double gains = 0, limits = 0;
  int within = 0;
  for (int n = 0; n < experiments; ++n) {
    const MeasuredData data = readings(random);
    const Dataset part = all_of(data);
    const Problem held_out = problem(part, Eigen::VectorXd::Constant(2 * row_count, sd_N));
    const NoiseLimit limit = noise_limit(held_out, forecast(part, Model{}));
    const double gain = (misfit(held_out, Model{}) - misfit(held_out, true_model())) / 2;
    gains += gain;
    limits += limit.log_likelihood_gain;
    within += gain >= limit.low && gain <= limit.high ? 1 : 0;
    EXPECT_NEAR(limit.rms_N, sd_N, 1e-12);
  }
  // The difference is (ν − χ²_ν) / 2, with ν = 60: standard deviation 5.5 for one experiment.
  EXPECT_NEAR(gains / experiments, limits / experiments, 3 * 5.5 / std::sqrt(experiments));
  EXPECT_NEAR(within, 0.95 * experiments, 3 * std::sqrt(0.95 * 0.05 * experiments));
}

// Two values a row, whose common scale is free: the forecasts T1 = w S and T2 = (1 - w) S add up to
// the readings, so that noise e leaves (1 - w) e1 - w e2 of T1, and as much of T2 with its sign
// turned.
TEST(NoiseLimit, CountsOutWhatAFreeScaleTakes) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, sd_N);
  double squares = 0, limits = 0;
  constexpr int experiments = 100;
  const double w = 1 / (1 + truth(0.18, 1, true) / truth(0.18, 1, false));
  for (int n = 0; n < experiments; ++n) {
    std::string text = "run,routing,T1_N,T2_N\n";
    for (int i = 0; i < row_count; ++i) {
      text += fmt::format("first,M-1-F,{},{}\n", truth(0.18, 10.0 + i, false) + noise(random),
                          truth(0.18, 10.0 + i, true) + noise(random));
    }
    const MeasuredData data = read_data(text);
    const Dataset part = all_of(data);
    const Problem held_out = problem(part, Eigen::VectorXd::Constant(2 * row_count, sd_N));
    const Forecast nominal = forecast(part, Model{});
    const NoiseLimit limit = noise_limit(held_out, nominal);
    const RunGain run = run_gains(held_out, nominal, nominal)[0];
    squares += run.rms_before_N * run.rms_before_N;
    limits += limit.rms_N * limit.rms_N;
    EXPECT_NEAR(limit.rms_N, sd_N * std::hypot(w, 1 - w), 1e-12);
    EXPECT_NEAR(run.rms_noise_N, limit.rms_N, 1e-12);
  }
  // Of 3000 degrees of freedom in all: standard deviation 2.6 %.
  EXPECT_NEAR(squares, limits, 3 * 0.026 * limits);
}

TEST(RunGains, AreTheResidualsOfEachRun) {
  std::mt19937 random(7);
  const MeasuredData data = readings(random);
  const Dataset part = all_of(data);
  const Problem held_out = problem(part, Eigen::VectorXd::Constant(2 * row_count, sd_N));
  const auto gains = run_gains(held_out, forecast(part, Model{}), forecast(part, true_model()));
  ASSERT_EQ(gains.size(), 2U);
  for (const RunGain& gain : gains) {
    double before = 0, after = 0, values = 0;
    for (const Reading& reading : data.readings) {
      if (reading.run != gain.run) continue;
      for (const bool beyond : {false, true}) {
        const double measured = *reading.tension_N[beyond ? 1 : 0];
        before += std::pow(measured - truth(0.18, *reading.motor_tension_N, beyond), 2);
        after += std::pow(measured - truth(0.09, *reading.motor_tension_N, beyond), 2);
        values += 1;
      }
    }
    EXPECT_EQ(gain.cells, static_cast<std::size_t>(values));
    EXPECT_NEAR(gain.rms_before_N, std::sqrt(before / values), 1e-6);
    EXPECT_NEAR(gain.rms_after_N, std::sqrt(after / values), 1e-6);
    EXPECT_NEAR(gain.rms_noise_N, sd_N, 1e-12);
  }
}

}  // namespace
}  // namespace reeve::testing
