#include "readings/log/ratio_noise.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "numerics/robust.hpp"

namespace reeve::readings {
namespace {

constexpr double hardly_apart = 1.5;

struct NoiseLevel {
  double tension_N = 0;
  double deviation_N = 0;
};

NoiseLevel level_of(const std::vector<ForecastError>& errors, std::size_t begin, std::size_t end) {
  std::vector<double> tensions;
  std::vector<double> sizes;
  for (std::size_t i = begin; i < end; ++i) {
    tensions.push_back(errors[i].tension_N);
    sizes.push_back(errors[i].error_N);
  }
  return {median(std::move(tensions)), mad_about_zero(std::move(sizes))};
}

double squared(double value) { return value * value; }

}  // namespace

double RatioNoise::at(double tension_N) const {
  return std::hypot(absolute_N, relative * std::max(tension_N, least_tension_N));
}

RatioNoise ratio_noise(std::vector<ForecastError> errors) {
  std::erase_if(errors, [](const ForecastError& error) { return std::isnan(error.error_N); });
  if (errors.empty()) return {};
  std::sort(errors.begin(), errors.end(), [](const ForecastError& a, const ForecastError& b) {
    return a.tension_N < b.tension_N;
  });
  const std::size_t count = errors.size();
  const std::size_t third = std::max<std::size_t>(1, count / 3);
  const NoiseLevel low = level_of(errors, 0, third);
  const NoiseLevel high = level_of(errors, count - third, count);
  if (!(high.tension_N > hardly_apart * low.tension_N) || high.deviation_N <= low.deviation_N) {
    return {0, level_of(errors, 0, count).deviation_N, 0};
  }
  const double slope = (squared(high.deviation_N) - squared(low.deviation_N)) /
                       (squared(high.tension_N) - squared(low.tension_N));
  const double relative = std::min(std::sqrt(slope), high.deviation_N / high.tension_N);
  const double left = squared(low.deviation_N) - squared(relative * low.tension_N);
  return {low.tension_N, std::sqrt(std::max(0.0, left)), relative};
}

}  // namespace reeve::readings
