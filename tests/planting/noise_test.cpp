#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/planting_noise.hpp"

namespace reeve::testing {
namespace {

struct Moments {
  double mean = 0, sd = 0, third = 0, fourth = 0;  // the last two of the standardised numbers
};

Moments moments(const NoiseLevel& noise, double tension_N) {
  NoiseSource source(noise, 7);
  constexpr int count = 200000;
  double sum = 0, squares = 0, cubes = 0, fourths = 0;
  for (int i = 0; i < count; ++i) {
    const double deviation = (source.reading(tension_N) - tension_N) /
                             std::hypot(noise.relative * tension_N, noise.absolute_N);
    sum += deviation;
    squares += std::pow(deviation, 2);
    cubes += std::pow(deviation, 3);
    fourths += std::pow(deviation, 4);
  }
  return {sum / count, std::sqrt(squares / count), cubes / count, fourths / count};
}

TEST(PlantedNoise, IsNormalAndGrowsWithTheTension) {
  for (const NoiseLevel& noise : {low_noise, high_noise}) {
    for (const double tension_N : {1.0, 30.0}) {
      const Moments found = moments(noise, tension_N);
      EXPECT_NEAR(found.mean, 0, 0.01);
      EXPECT_NEAR(found.sd, 1, 0.01);
      EXPECT_NEAR(found.third, 0, 0.03);
      EXPECT_NEAR(found.fourth, 3, 0.1);
    }
  }
}

TEST(PlantedNoise, NeverReadsBelowZero) {
  NoiseSource source(high_noise, 1);
  int zeros = 0;
  for (int i = 0; i < 1000; ++i) {
    const double reading = source.reading(0);
    EXPECT_GE(reading, 0);
    zeros += reading == 0;
  }
  EXPECT_NEAR(zeros, 500, 60);
}

TEST(PlantedNoise, LikelihoodsAddUpToOne) {
  for (const double mean_N : {0.0, 0.03, 2.0}) {
    const double step = 1e-4;
    double sum = std::exp(log_likelihood(high_noise, mean_N, 0));
    for (double reading = step / 2; reading < 5; reading += step) {
      sum += step * std::exp(log_likelihood(high_noise, mean_N, reading));
    }
    EXPECT_NEAR(sum, 1, 1e-6) << mean_N;
  }
}

}  // namespace
}  // namespace reeve::testing
