#include "diagnosis/verdict/held_out.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/diagnosis/pattern_bench.hpp"

namespace reeve::testing {
namespace {

// Readings without noise, off by so much on T1 in each run.
HeldOut gain_of(const std::vector<double>& offset_by_run, std::size_t rows, double size) {
  const Bench bench({offset_by_run.size(), rows, 1, 0},
                    [&](std::size_t run) { return Pattern{offset_by_run[run]}; });
  return held_out_gain(bench.problem, {}, on_T1.model(size), 1);
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

// One run gains much, all others lose a little. Of five runs a third of the samples has that one
// not at all; of readings drawn one by one every sample has some.
TEST(HeldOutGain, ResamplesWholeRunsWhereThereAreFive) {
  const HeldOut five = gain_of({4, 0, 0, 0, 0}, 24, 0.5);
  EXPECT_GT(five.log_likelihood_gain, 0);
  EXPECT_LT(five.gain_low, 0);
  EXPECT_LE(five.low, 0);
  const HeldOut four = gain_of({4, 0, 0, 0}, 24, 0.5);
  EXPECT_GT(four.gain_low, 0);
  EXPECT_GT(four.low, 0);
}

// A sample of 40 runs, half of which gain: 20 of those ± 6.2 with a probability of 95 %.
TEST(HeldOutGain, HasTheIntervalOfTheMiddle95PercentOfTheSamples) {
  std::vector<double> offsets(40, 0);
  for (std::size_t run = 0; run < 40; run += 2) offsets[run] = 1;
  const HeldOut gain = gain_of(offsets, 1, 0.5);
  // A run that is off gains (1 - 0.25) / 2 sd², the others lose 0.25 / 2 sd².
  const double unit = 0.5 / (bench_noise_N * bench_noise_N);
  const double none = -40 * 0.25 / 2 / (bench_noise_N * bench_noise_N);
  EXPECT_NEAR((gain.gain_low - none) / unit, 14, 1.01);
  EXPECT_NEAR((gain.gain_high - none) / unit, 26, 1.01);
  const auto reduction = [](double off) { return 1 - std::sqrt(40 * 0.25 / off); };
  EXPECT_NEAR(gain.low, reduction(14), reduction(15) - reduction(14) + 1e-6);
  EXPECT_NEAR(gain.high, reduction(26), reduction(27) - reduction(26) + 1e-6);
}

TEST(HeldOutGain, IsDrawnByTheSeed) {
  const Bench bench({1}, {4, 6});
  const Model later = on_T1.model(0.9);
  const HeldOut one = held_out_gain(bench.problem, {}, later, 1);
  EXPECT_EQ(held_out_gain(bench.problem, {}, later, 1).gain_low, one.gain_low);
  EXPECT_NE(held_out_gain(bench.problem, {}, later, 2).gain_low, one.gain_low);
}

}  // namespace
}  // namespace reeve::testing
