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
  if (reading_N <= 0) {
    const double below = 0.5 * std::erfc(mean_N / sd / std::numbers::sqrt2);
    return std::log(std::max(below, 1e-300));
  }
  const double deviation = (reading_N - mean_N) / sd;
  return -0.5 * deviation * deviation - std::log(sd * std::sqrt(2 * std::numbers::pi));
}

double NoiseSource::uniform() { return static_cast<double>((engine_() >> 11) + 1) * 0x1p-53; }

double NoiseSource::reading(double mean_N) {
  const double radius = std::sqrt(-2 * std::log(uniform()));
  const double angle = 2 * std::numbers::pi * uniform();
  const double relative = noise_.relative * radius * std::cos(angle);
  const double absolute_N = noise_.absolute_N * radius * std::sin(angle);
  return std::max(0.0, mean_N * (1 + relative) + absolute_N);
}

}  // namespace reeve::testing
