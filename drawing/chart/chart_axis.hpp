// An axis as it is drawn: its scale, and where which ticks lie along it.
#pragma once

#include <string>
#include <vector>

#include "drawing/chart/chart.hpp"
#include "drawing/chart/chart_extent.hpp"
#include "drawing/chart/chart_scale.hpp"

namespace reeve::drawing::chart {

inline constexpr double tick_size = 12;  // of the text
inline constexpr double line_height = 15;

struct Tick {
  double value = 0;
  double at = 0;     // px, along the axis
  std::string text;  // "" where it would lie over that of another
};

struct LaidAxis {
  Scale scale;
  std::vector<Tick> ticks;
};

// A stretch of the picture: the low end of the axis lies at `from`, but for what stays free.
struct Stretch {
  double from = 0;
  double to = 0;
  Inset inset;
};

// For numbers; the extent has a length. As many ticks as have room for their texts, which lie along
// (x) or across the axis (y).
LaidAxis lay_numbers(const Axis& axis, const Extent& extent, const Stretch& stretch, Along along);

// A tick for each category; the layout of their texts is somebody else's.
LaidAxis lay_categories(const Axis& axis, const Stretch& stretch);

}  // namespace reeve::drawing::chart
