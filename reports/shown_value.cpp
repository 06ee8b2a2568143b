#include "reports/shown_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"

namespace reeve::reports {

int telling_digits(std::vector<double> values, int at_least) {
  constexpr int most = 12;
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  const auto tells = [&](int digits) {
    return std::adjacent_find(values.begin(), values.end(), [&](double a, double b) {
             return fmt::format("{:.{}g}", a, digits) == fmt::format("{:.{}g}", b, digits);
           }) == values.end();
  };
  int digits = at_least;
  while (digits < most && !tells(digits)) ++digits;
  return digits;
}

int telling_decimals(double span, std::size_t steps, int at_least) {
  constexpr int most = 9;
  int decimals = at_least;
  if (!(span > 0)) return decimals;
  while (decimals < most && span * std::pow(10, decimals) < static_cast<double>(steps)) ++decimals;
  return decimals;
}

int significant_decimals(double value, int at_least) {
  if (!std::isfinite(value) || value == 0) return at_least;
  constexpr int digits = 3;
  constexpr int most = 10;
  const int before_point = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  int decimals = std::clamp(digits - before_point, at_least, most);
  std::string text = fmt::format("{:.{}f}", value, decimals);
  for (; decimals > at_least && text.back() == '0'; --decimals) text.pop_back();
  return decimals;
}

std::string rounded_text(double value, Rounding way) {
  if (!std::isfinite(value) || value == 0) return fmt::format("{}", value);
  constexpr int digits = 4;
  const int before_point = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  const int decimals = std::clamp(digits - before_point, 0, 10);
  const double power = std::pow(10, decimals);
  // A value that has no more digits stays itself, whatever the product's last bit.
  constexpr double rounding_error = 1e-9;
  const double scaled = value * power;
  const double whole = way == Rounding::up ? std::ceil(scaled - rounding_error)
                                           : std::floor(scaled + rounding_error);
  return fmt::format("{}", whole / power);
}

int shown_decimals(Objective objective, double value, int at_least) {
  return objective == Objective::cost ? significant_decimals(value, at_least) : at_least;
}

int shown_decimals(Objective objective, double value) {
  return shown_decimals(objective, value, row(objective).decimals);
}

int shown_decimals(Objective objective, const std::vector<ListedDesign>& designs) {
  int decimals = row(objective).decimals;
  for (const ListedDesign& design : designs) {
    const double shown = value(design.ranked.design.values, objective);
    decimals = std::max(decimals, shown_decimals(objective, shown));
  }
  return decimals;
}

std::string objective_text(Objective objective, double value) {
  return fixed(value, shown_decimals(objective, value, row(objective).is_count() ? 0 : 3));
}

std::string shown_value(Objective objective, double value) {
  return fixed(value, shown_decimals(objective, value));
}

}  // namespace reeve::reports
