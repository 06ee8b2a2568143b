// An axis: its scale, from a quantity to pixels and back, and which of its values get a tick.
//
// p(v) = from + (f(v) − f(low)) / (f(high) − f(low)) · (to − from), where f(v) = v, or with
// c = linear_to > 0 f(v) = sign(v) ln(1 + |v| / c): linear where |v| ≪ c, logarithmic where |v| ≫
// c, so that 0 and both signs have a place (Webber, "A bi-symmetric log transformation for
// wide-range data", Meas. Sci. Technol. 24, 2013).
//
// Ticks of a linear axis: multiples of a step of 1, 2 or 5 times a power of ten, from at or below
// the least value to at or above the greatest ("loose" labels of Heckbert, "Nice numbers for graph
// labels", Graphics Gems, 1990); of such steps the finest that gives no more ticks than asked for.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "drawing/chart/chart.hpp"

namespace reeve::drawing::chart {

struct Scale {
  double low = 0;  // least value of the quantity; less than `high`
  double high = 1;
  double from = 0;  // pixels: where `low` lies
  double to = 1;
  double linear_to = 0;
};

double place(const Scale& scale, double value);
double value(const Scale& scale, double place);

// Numbers that an axis can hold: finite, and no further from 0 than 1e100.
bool can_be_drawn(double value);
bool can_be_drawn(const Point& at);
bool can_be_drawn(const Spot& spot);
bool can_be_drawn(const Span& span);
bool can_be_drawn(const Level& level);

// Range from the least to the greatest of some numbers; empty at first.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool empty() const { return low > high; }
  // Leaves out what cannot be drawn.
  void add(double value);
  void add(const Extent& other);
};

struct Ticks {
  std::vector<double> values;  // ascending
  double step = 1;
};

// The extent has a length; `most` is at least 3, which a step always meets. `whole`: no step
// below 1.
Ticks nice_ticks(const Extent& extent, std::size_t most, bool whole = false);

// Ticks of an axis that is logarithmic beyond `linear_to`: 0 and 1, 3, 10, 30, … from there on, of
// both signs, within the extent. The most important come first: 0, powers of ten, the rest.
std::vector<double> bent_ticks(const Extent& extent, double linear_to);

// Formats with as many decimals as the step has.
std::string tick_text(double value, double step, Format format);
// Formats with as many decimals as the value needs.
std::string tick_text(double value, Format format);

inline constexpr double tick_size = 12;  // size of the text, px

struct Tick {
  double value = 0;
  double at = 0;     // px, along the axis
  std::string text;  // "" where it would lie over that of another
};

struct LaidAxis {
  Scale scale;
  std::vector<Tick> ticks;
};

// Room that stays free at the ends of an axis, px, so that no symbol leaves the frame: half the
// largest one, of which categories have their share. Bars stand on the frame.
struct Inset {
  double low = 0;
  double high = 0;
};

// A stretch of the chart: the low end of the axis lies at `from`, but for what stays free.
struct Stretch {
  double from = 0;
  double to = 0;
  Inset inset;
};

// Lays an axis of numbers; the extent has a length. It has as many ticks as have room for their
// texts, which lie along (x) or across the axis (y).
LaidAxis lay_numbers(const Axis& axis, const Extent& extent, const Stretch& stretch, Along along);

// Sets a tick for each category; the caller lays out their texts.
LaidAxis lay_categories(const Axis& axis, const Stretch& stretch);

}  // namespace reeve::drawing::chart
