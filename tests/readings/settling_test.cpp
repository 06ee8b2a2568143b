// The noise of forecasts in newton, and what the readings of nearly slack strands owe to it.
#include "readings/log/settling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "numerics/random.hpp"
#include "tests/readings/rig_readings.hpp"

namespace reeve::testing {
namespace {

// Of tensions of 0.5, 3 and 20 N, whose forecasts scatter by these two parts.
RatioNoise noise_of(double absolute_N, double share) {
  std::vector<ForecastError> errors;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const double tension_N = std::vector{0.5, 3.0, 20.0}[i % 3];
    errors.push_back({tension_N, std::hypot(absolute_N, share * tension_N) * normal(1, 0, i)});
  }
  return ratio_noise(errors);
}

TEST(RatioNoise, OfASensorIsSoManyNewtonWhateverItReads) {
  const RatioNoise noise = noise_of(0.1, 0);
  for (const double tension_N : {0.0, 0.5, 3.0, 20.0}) {
    EXPECT_NEAR(noise.at(tension_N), 0.1, 0.01) << tension_N;
  }
}

TEST(RatioNoise, MayBeAShareOfTheTension) {
  const RatioNoise noise = noise_of(0, 0.02);
  EXPECT_NEAR(noise.at(20), 0.4, 0.04);
  EXPECT_NEAR(noise.at(3), 0.06, 0.006);
  EXPECT_NEAR(noise.at(0.5), 0.01, 0.001);
  EXPECT_EQ(noise.at(0), noise.at(0.5));
}

TEST(RatioNoise, MayBeBoth) {
  const RatioNoise noise = noise_of(0.05, 0.02);
  EXPECT_NEAR(noise.at(0.5), 0.05, 0.005);
  EXPECT_NEAR(noise.at(20), 0.403, 0.04);
}

TEST(RatioNoise, IsZeroWithoutReadings) {
  EXPECT_EQ(ratio_noise({}).at(7), 0);
  EXPECT_EQ(ratio_noise({{3, NAN}}).at(7), 0);
}

// A carriage to and fro at a motor tension that a controller holds. Contacts begin to slide over
// 1.5 mm after each turn; two of the strands are nearly slack while it pulls.
std::vector<RigSample> log_at_held_load(double noise_N, double correlation) {
  constexpr double load_N = 24;
  const std::vector<RigStrand> strands{{0.57, 1.2}, {0.19, 0.7}, {0.016, 0.25}, {0.009, 0.14}};
  std::vector<RigSample> samples;
  double position_mm = 0;
  double pulled = 1;  // 0: the ratios are those of releasing
  for (int i = 0; i < 2400; ++i) {
    const int phase = i % 600;  // out 2 s, rest 1 s, back 2 s, rest 1 s
    const double way = phase < 200 ? 1 : phase >= 300 && phase < 500 ? -1 : 0;
    const double into_s = 0.01 * (phase % 300);
    const double speed = way * 10 * std::clamp(std::min(into_s, 2 - into_s) / 0.2, 0.005, 1.0);
    position_mm += 0.01 * speed;
    pulled = std::clamp(pulled + 0.01 * speed / 1.5, 0.0, 1.0);
    const bool slides = way != 0 && pulled == (way > 0 ? 1 : 0);
    RigSample sample{0, 0.01 * i, position_mm, speed, load_N, {}, slides, load_N, {}};
    for (const RigStrand& strand : strands) {
      const double ratio = strand.release + pulled * (strand.pull - strand.release);
      sample.strands_N.push_back(ratio * load_N);
    }
    samples.push_back(std::move(sample));
  }
  for (std::uint32_t channel = 0; channel <= strands.size(); ++channel) {
    const std::vector<double> noise = correlated_noise(samples.size(), correlation, 7, channel);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      RigSample& at = samples[i];
      if (channel == 0) {
        at.motor_read_N += noise_N * noise[i];
      } else {
        at.strands_read_N.push_back(at.strands_N[channel - 1] + noise_N * noise[i]);
      }
    }
  }
  return samples;
}

TEST(SteadyReadings, AreTakenOfNearlySlackStrandsWhateverTheNoise) {
  for (const double noise_N : {0.001, 0.005, 0.02, 0.1, 0.2}) {
    for (const double correlation : {0.0, 0.7}) {
      const std::vector<RigSample> samples = log_at_held_load(noise_N, correlation);
      const SteadyReadings found = steady_readings(series_of(samples), {});
      EXPECT_EQ(found.readings.size(), 8U) << noise_N << " N, " << correlation;
      expect_sound(samples, found);
      EXPECT_GT(share_within(deviations_from_truth(samples, found), 3), 0.9);
    }
  }
}

}  // namespace
}  // namespace reeve::testing
