#include "drawing/chart/chart_axis.hpp"

#include <algorithm>
#include <cmath>

#include "drawing/chart/chart_ticks.hpp"

namespace reeve::drawing::chart {
namespace {

constexpr double least_gap = 10;  // px between two texts

// What the text takes along the axis.
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

// Those that come first keep their texts.
void drop_overlapping(std::vector<Tick>& ticks, Along along) {
  std::vector<Tick*> kept;
  for (Tick& tick : ticks) {
    const bool free = std::none_of(kept.begin(), kept.end(),
                                   [&](const Tick* other) { return overlap(tick, *other, along); });
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

// Where a tick would lie beyond what is possible, the limit itself gets one.
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
  std::sort(laid.ticks.begin(), laid.ticks.end(),
            [](const Tick& a, const Tick& b) { return a.value < b.value; });
  return laid;
}

}  // namespace

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
