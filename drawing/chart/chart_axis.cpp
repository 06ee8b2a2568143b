#include "drawing/chart/chart_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reeve::drawing::chart {
namespace {

double bent(double value, double linear_to) {
  return linear_to > 0 ? std::copysign(std::log1p(std::abs(value) / linear_to), value) : value;
}

double straight(double bent, double linear_to) {
  return linear_to > 0 ? std::copysign(linear_to * std::expm1(std::abs(bent)), bent) : bent;
}

constexpr double slack = 1e-9;  // share of a step, for rounding errors of its multiples

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

constexpr double least_gap = 10;  // px between two texts

// Returns the length of the text along the axis.
double room(const std::string& text, Along along) {
  return along == Along::y ? tick_size : measures::text_width(text, tick_size, false);
}

bool overlap(const Tick& a, const Tick& b, Along along) {
  return std::abs(a.at - b.at) < (room(a.text, along) + room(b.text, along)) / 2 + least_gap;
}

bool has_room_for_all(const std::vector<Tick>& ticks, Along along) {
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    if (overlap(ticks[i - 1], ticks[i], along)) return false;
  }
  return true;
}

// Clears the texts that overlap an earlier one.
void drop_overlapping(std::vector<Tick>& ticks, Along along) {
  std::vector<Tick*> kept;
  for (Tick& tick : ticks) {
    const bool free =
        std::ranges::none_of(kept, [&](const Tick* other) { return overlap(tick, *other, along); });
    if (free) {
      kept.push_back(&tick);
    } else {
      tick.text.clear();
    }
  }
}

Scale scale(const Extent& extent, const Stretch& stretch, double linear_to) {
  const double sign = stretch.to < stretch.from ? -1 : 1;
  return {extent.low, extent.high, stretch.from + sign * stretch.inset.low,
          stretch.to - sign * stretch.inset.high, linear_to};
}

// The ticks at the ends may lie beyond the marks, but not where that would leave more than half a
// step empty, as long as two ticks remain.
void trim(Ticks& ticks, const Extent& extent) {
  std::vector<double>& values = ticks.values;
  const auto is_far = [&](double by) { return by > 0.5 * ticks.step; };
  if (values.size() > 2 && is_far(values.back() - extent.high)) values.pop_back();
  if (values.size() > 2 && is_far(extent.low - values.front())) values.erase(values.begin());
}

// Adds ticks. A tick beyond the possible values is replaced by one at the limit.
LaidAxis with_ticks(const Axis& axis, const Extent& extent, const Stretch& stretch,
                    std::size_t most) {
  Ticks nice = nice_ticks(extent, most, axis.whole);
  LaidAxis laid;
  Extent reach = extent;
  const auto add = [&](double value, const std::string& text) {
    reach.add(value);
    laid.ticks.push_back({value, 0, text});
  };
  const auto add_limit = [&](double value) { add(value, tick_text(value, axis.format)); };
  if (axis.least && nice.values.front() < *axis.least) add_limit(*axis.least);
  const bool ends_at_limit = axis.greatest && nice.values.back() > *axis.greatest;
  trim(nice, extent);
  for (const double value : nice.values) {
    if (value < axis.least.value_or(value) || value > axis.greatest.value_or(value)) continue;
    add(value, tick_text(value, nice.step, axis.format));
  }
  if (ends_at_limit) add_limit(*axis.greatest);
  laid.scale = scale(reach, stretch, 0);
  for (Tick& tick : laid.ticks) tick.at = place(laid.scale, tick.value);
  return laid;
}

LaidAxis lay_linear(const Axis& axis, const Extent& extent, const Stretch& stretch, Along along) {
  const double length = std::abs(stretch.to - stretch.from);
  const double wanted = length / (along == Along::x ? 40 : 28);
  auto most = static_cast<std::size_t>(std::clamp(wanted, 3.0, 11.0));
  LaidAxis laid = with_ticks(axis, extent, stretch, most);
  while (!has_room_for_all(laid.ticks, along) && most > 3) {
    laid = with_ticks(axis, extent, stretch, --most);
  }
  drop_overlapping(laid.ticks, along);
  return laid;
}

LaidAxis lay_bent(const Axis& axis, const Extent& extent, const Stretch& stretch, Along along) {
  LaidAxis laid{scale(extent, stretch, axis.linear_to), {}};
  for (const double value : bent_ticks(extent, axis.linear_to)) {
    laid.ticks.push_back({value, place(laid.scale, value), tick_text(value, axis.format)});
  }
  drop_overlapping(laid.ticks, along);
  std::ranges::sort(laid.ticks, {}, &Tick::value);
  return laid;
}

}  // namespace

double place(const Scale& scale, double value) {
  const double low = bent(scale.low, scale.linear_to);
  const double high = bent(scale.high, scale.linear_to);
  return scale.from + (bent(value, scale.linear_to) - low) / (high - low) * (scale.to - scale.from);
}

double value(const Scale& scale, double place) {
  const double low = bent(scale.low, scale.linear_to);
  const double high = bent(scale.high, scale.linear_to);
  const double share = (place - scale.from) / (scale.to - scale.from);
  return straight(low + share * (high - low), scale.linear_to);
}

bool can_be_drawn(double value) { return std::isfinite(value) && std::abs(value) <= 1e100; }
bool can_be_drawn(const Point& at) { return can_be_drawn(at.x) && can_be_drawn(at.y); }
bool can_be_drawn(const Spot& spot) { return can_be_drawn(spot.x) && can_be_drawn(spot.y); }
bool can_be_drawn(const Level& level) { return can_be_drawn(level.at); }
bool can_be_drawn(const Span& span) {
  return can_be_drawn(span.at) && can_be_drawn(span.low) && can_be_drawn(span.high);
}

void Extent::add(double value) {
  if (!can_be_drawn(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

void Extent::add(const Extent& other) {
  if (other.empty()) return;
  add(other.low);
  add(other.high);
}

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
  std::ranges::reverse(ones);
  std::ranges::reverse(threes);
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

LaidAxis lay_numbers(const Axis& axis, const Extent& extent, const Stretch& stretch, Along along) {
  if (axis.hidden) return {scale(extent, stretch, axis.linear_to), {}};
  return axis.linear_to > 0 ? lay_bent(axis, extent, stretch, along)
                            : lay_linear(axis, extent, stretch, along);
}

LaidAxis lay_categories(const Axis& axis, const Stretch& stretch) {
  const double last = static_cast<double>(axis.categories.size()) - 0.5;
  LaidAxis laid{scale({-0.5, last}, stretch, 0), {}};
  for (std::size_t i = 0; i < axis.categories.size(); ++i) {
    const auto value = static_cast<double>(i);
    laid.ticks.push_back({value, place(laid.scale, value), axis.categories[i]});
  }
  return laid;
}

}  // namespace reeve::drawing::chart
