#include "tests/support/planting_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reeve::testing {

double standard_deviation(const NoiseLevel& noise, double mean_N) {
  return std::hypot(noise.relative * mean_N, noise.absolute_N);
}

double log_likelihood(const NoiseLevel& noise, double mean_N, double reading_N) {
  const double sd = standard_deviation(noise, mean_N);
  if (reading_N <= 0 && !noise.below_zero) {
    const double below = 0.5 * std::erfc(mean_N / sd / std::numbers::sqrt2);
    return std::log(std::max(below, 1e-300));
  }
  const double deviation = (reading_N - mean_N) / sd;
  return -0.5 * deviation * deviation - std::log(sd * std::sqrt(2 * std::numbers::pi));
}

double NoiseSource::uniform() { return static_cast<double>((engine_() >> 11) + 1) * 0x1p-53; }

double NoiseSource::stretch() {
  if (noise_.tail_degrees == 0) return 1;
  const double degrees = noise_.tail_degrees;
  double chi_squared = 0;
  for (int i = 0; i < noise_.tail_degrees; ++i) {
    const double z =
        std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform());
    chi_squared += z * z;
  }
  return std::sqrt((degrees - 2) / chi_squared);
}

double NoiseSource::reading(double mean_N) {
  const double radius = stretch() * std::sqrt(-2 * std::log(uniform()));
  const double angle = 2 * std::numbers::pi * uniform();
  const double relative = noise_.relative * radius * std::cos(angle);
  const double absolute_N = noise_.absolute_N * radius * std::sin(angle);
  const double reading = mean_N * (1 + relative) + absolute_N;
  return noise_.below_zero ? reading : std::max(0.0, reading);
}

}  // namespace reeve::testing
