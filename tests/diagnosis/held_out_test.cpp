#include "diagnosis/verdict/held_out.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/diagnosis/pattern_bench.hpp"

namespace reeve::testing {
namespace {

HeldOut gain_of(const Bench& bench, const Model& later, std::uint64_t seed) {
  return held_out_gain(bench.problem, forecast(bench.dataset, {}), forecast(bench.dataset, later),
                       seed);
}

// Readings without noise, off by so much on T1 in each run.
HeldOut gain_of(const std::vector<double>& offset_by_run, std::size_t rows, double size) {
  const Bench bench({offset_by_run.size(), rows, 1, 0},
                    [&](std::size_t run) { return Pattern{offset_by_run[run]}; });
  return gain_of(bench, on_T1.model(size), 1);
}

// Two runs, off by 1 and by 2 N; the later model says 1.5 N. Three of four readings are never off.
TEST(HeldOutGain, ComparesResidualsInNewtonAndLikelihoods) {
  const HeldOut gain = gain_of({1, 2}, 10, 1.5);
  const double variance = bench_noise_N * bench_noise_N;
  EXPECT_NEAR(gain.rms_before_N, std::sqrt((1.0 + 4.0) / 8), 1e-9);
  EXPECT_NEAR(gain.rms_after_N, std::sqrt((0.25 + 0.25) / 8), 1e-9);
  EXPECT_NEAR(gain.reduction, 1 - std::sqrt(0.1), 1e-9);
  EXPECT_NEAR(gain.log_likelihood_gain, 10 * (5 - 0.5) / variance / 2, 1e-5);
  EXPECT_NEAR(gain.expected_gain, 20 * 1.5 * 1.5 / variance / 2, 1e-5);
}

TEST(HeldOutGain, OfTheSameModelIsNothing) {
  const HeldOut gain = gain_of({1, 2}, 10, 0);
  EXPECT_EQ(gain.reduction, 0);
  EXPECT_EQ(gain.log_likelihood_gain, 0);
  EXPECT_EQ(gain.gain_low, 0);
  EXPECT_EQ(gain.gain_high, 0);
}

// One run in five alone gains: its share of the whole is of the Beta(1, 4) distribution, of which
// 1 in 40 is below 1 - 0.975^(1/4) and 1 in 40 above 1 - 0.025^(1/4). Drawn anew with replacement,
// it would be missing in a third of the samples.
TEST(HeldOutGain, WeighsWholeRunsWhereThereAreFive) {
  const HeldOut five = gain_of({4, 0.25, 0.25, 0.25, 0.25}, 24, 0.5);
  const double all = five.log_likelihood_gain;
  EXPECT_NEAR(five.gain_high / all, 5 * (1 - std::pow(0.025, 0.25)), 0.3);
  EXPECT_NEAR(five.gain_low / all, 5 * (1 - std::pow(0.975, 0.25)), 0.02);
  // Of 96 rows a quarter gains: sd of the share sqrt(3) / sqrt(97) of it.
  const HeldOut four = gain_of({4, 0.25, 0.25, 0.25}, 24, 0.5);
  EXPECT_NEAR(four.gain_low / four.log_likelihood_gain, 1 - 1.96 * std::sqrt(3.0 / 97), 0.06);
}

TEST(HeldOutGain, KnowsWhereTheOthersLose) {
  const HeldOut gain = gain_of({4, 0, 0, 0, 0}, 24, 0.5);
  EXPECT_GT(gain.log_likelihood_gain, 0);
  EXPECT_LT(gain.gain_low, 0);
  EXPECT_LT(gain.low, 0);
}

// Of 40 runs, half of which gain: their share is of the Beta(20, 20) distribution, 0.5 ± 0.153 with
// a probability of 95 %.
TEST(HeldOutGain, HasTheIntervalOfTheMiddle95Percent) {
  std::vector<double> offsets(40, 0);
  for (std::size_t run = 0; run < 40; run += 2) offsets[run] = 1;
  const HeldOut gain = gain_of(offsets, 1, 0.5);
  // A run that is off gains (1 - 0.25) / 2 sd², the others lose 0.25 / 2 sd².
  const double unit = 0.5 / (bench_noise_N * bench_noise_N);
  const double none = -40 * 0.25 / 2 / (bench_noise_N * bench_noise_N);
  EXPECT_NEAR((gain.gain_low - none) / unit, 20 - 6.1, 1);
  EXPECT_NEAR((gain.gain_high - none) / unit, 20 + 6.1, 1);
  const auto reduction = [](double off) { return 1 - std::sqrt(40 * 0.25 / off); };
  EXPECT_NEAR(gain.low, reduction(13.9), reduction(14.9) - reduction(13.9));
  EXPECT_NEAR(gain.high, reduction(26.1), reduction(27.1) - reduction(26.1));
}

TEST(HeldOutGain, IsDrawnByTheSeed) {
  const Bench bench({1}, {4, 6});
  const Model later = on_T1.model(0.9);
  const HeldOut one = gain_of(bench, later, 1);
  EXPECT_EQ(gain_of(bench, later, 1).gain_low, one.gain_low);
  EXPECT_NE(gain_of(bench, later, 2).gain_low, one.gain_low);
}

}  // namespace
}  // namespace reeve::testing
