#include "numerics/robust.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace reeve::numerics {

double quantile_of(std::vector<double> values, double share) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto last = static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(share * last);
  std::nth_element(values.begin(), values.begin() + below, values.end());
  const double low = values[static_cast<std::size_t>(below)];
  const double rest = share * last - static_cast<double>(below);
  if (rest == 0) return low;
  const double high = *std::min_element(values.begin() + below + 1, values.end());
  return low + rest * (high - low);
}

double median(std::vector<double> values) { return quantile_of(std::move(values), 0.5); }

double mad_about_zero(std::vector<double> values) {
  constexpr double of_normal = 0.6745;
  for (double& value : values) value = std::abs(value);
  const double middle = median(std::move(values));
  return std::isnan(middle) ? 0 : middle / of_normal;
}

double deviation_about_trend(const std::vector<std::vector<double>>& series) {
  constexpr double of_second_differences = 2.449489742783178;  // √6
  std::vector<double> differences;
  for (const std::vector<double>& values : series) {
    for (std::size_t i = 2; i < values.size(); ++i) {
      differences.push_back(values[i] - 2 * values[i - 1] + values[i - 2]);
    }
  }
  return mad_about_zero(std::move(differences)) / of_second_differences;
}

}  // namespace reeve::numerics
