#include "drawing/chart/chart_ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace reeve::drawing::chart {
namespace {

constexpr double slack = 1e-9;  // of a step: what rounding may make of a multiple of it

double first_multiple(const Extent& extent, double step) {
  return std::floor(extent.low / step + slack);
}

double last_multiple(const Extent& extent, double step) {
  return std::ceil(extent.high / step - slack);
}

// A step that numbers of this size cannot resolve would give the same tick twice.
double least_step(const Extent& extent, bool whole) {
  const double resolved = 1e-12 * std::max(std::abs(extent.low), std::abs(extent.high));
  return std::max(resolved, whole ? 1.0 : 0.0);
}

// Division, since 0.1 is no binary number and 1 / 10 is the nearest one to it.
double times_ten_to(double digit, double power) {
  return power < 0 ? digit / std::pow(10, -power) : digit * std::pow(10, power);
}

double finest_step(const Extent& extent, std::size_t most, bool whole) {
  const double least =
      std::max((extent.high - extent.low) / static_cast<double>(most), least_step(extent, whole));
  for (double power = std::floor(std::log10(least));; ++power) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double step = times_ten_to(digit, power);
      if (step < least * (1 - slack)) continue;
      const double count = last_multiple(extent, step) - first_multiple(extent, step) + 1;
      if (count <= static_cast<double>(most)) return step;
    }
  }
}

int decimals(double step) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - slack)), 0, 12);
}

// Typographic, as a hyphen is too short beside digits.
std::string with_sign(std::string text, Format format) {
  const bool is_zero = text.find_first_of("123456789") == std::string::npos;
  if (text.front() == '-') text = is_zero ? text.substr(1) : "\xe2\x88\x92" + text.substr(1);
  return format == Format::with_sign && !is_zero && text.front() != '\xe2' ? "+" + text : text;
}

}  // namespace

Ticks nice_ticks(const Extent& extent, std::size_t most, bool whole) {
  const double step = finest_step(extent, std::max<std::size_t>(most, 3), whole);
  const double first = first_multiple(extent, step);
  const auto count = static_cast<std::size_t>(last_multiple(extent, step) - first) + 1;
  const double per_one = std::round(1 / step);
  Ticks ticks{{}, step};
  for (std::size_t i = 0; i < count; ++i) {
    const double multiple = first + static_cast<double>(i);
    // 3 / 10 is the nearest number to 0.3, 3 · 0.1 is not.
    ticks.values.push_back(step < 1 ? multiple / per_one : multiple * step);
  }
  return ticks;
}

std::vector<double> bent_ticks(const Extent& extent, double linear_to) {
  std::vector<double> ones;
  std::vector<double> threes;
  const double greatest = std::max(std::abs(extent.low), std::abs(extent.high));
  for (double power = std::floor(std::log10(linear_to)); std::pow(10, power) <= greatest; ++power) {
    ones.push_back(times_ten_to(1, power));
    threes.push_back(times_ten_to(3, power));
  }
  // The greatest first: they say how far the axis reaches.
  std::reverse(ones.begin(), ones.end());
  std::reverse(threes.begin(), threes.end());
  ones.insert(ones.end(), threes.begin(), threes.end());
  std::vector<double> ticks;
  const auto add = [&](double value) {
    if (value >= extent.low && value <= extent.high) ticks.push_back(value);
  };
  add(0);
  for (const double magnitude : ones) {
    if (magnitude < linear_to * (1 - slack)) continue;
    add(magnitude);
    add(-magnitude);
  }
  return ticks;
}

std::string tick_text(double value, double step, Format format) {
  const double shown = format == Format::percent ? 100 * value : value;
  const double shown_step = format == Format::percent ? 100 * step : step;
  const bool plain = std::abs(shown) < 1e7 && shown_step >= 1e-6;
  std::string text =
      plain ? fmt::format("{:.{}f}", shown, decimals(shown_step)) : fmt::format("{:.6g}", shown);
  return with_sign(std::move(text), format) + (format == Format::percent ? " %" : "");
}

std::string tick_text(double value, Format format) {
  const double shown = format == Format::percent ? 100 * value : value;
  return with_sign(fmt::format("{:.6g}", shown), format) + (format == Format::percent ? " %" : "");
}

}  // namespace reeve::drawing::chart
