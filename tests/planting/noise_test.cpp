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

TEST(PlantedNoise, ReadsBelowZeroWhereItsSensorsDo) {
  NoiseLevel noise = high_noise;
  noise.below_zero = true;
  NoiseSource source(noise, 1);
  int below = 0;
  for (int i = 0; i < 1000; ++i) below += source.reading(0) < 0;
  EXPECT_NEAR(below, 500, 60);
  EXPECT_DOUBLE_EQ(log_likelihood(noise, 0, -0.07), log_likelihood(noise, 0, 0.07));
}

// Student's t of 3 degrees has its quartile at 0.7649 and 5 % beyond 3.1824, in units in which its
// variance is 3; its fourth moment is infinite, so that the deviation of a sample says little.
TEST(PlantedNoise, HasTheTailsOfStudentsTAndTheStandardDeviationThatItPromises) {
  constexpr int count = 200000;
  NoiseLevel noise = low_noise;
  noise.tail_degrees = 3;
  noise.below_zero = true;
  NoiseSource source(noise, 7);
  int middle = 0;
  int far = 0;
  for (int i = 0; i < count; ++i) {
    const double deviation =
        std::abs(source.reading(20) - 20) / standard_deviation(noise, 20) * std::sqrt(3);
    middle += deviation < 0.7649;
    far += deviation > 3.1824;
  }
  EXPECT_NEAR(static_cast<double>(middle) / count, 0.5, 0.005);
  EXPECT_NEAR(static_cast<double>(far) / count, 0.05, 0.002);
  noise.tail_degrees = 8;
  EXPECT_NEAR(moments(noise, 20).sd, 1, 0.01);
  EXPECT_NEAR(moments(noise, 20).fourth, 4.5, 0.3);
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
