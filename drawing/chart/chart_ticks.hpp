// Which values of an axis get a tick, and how they are written.
//
// Linear: multiples of a step of 1, 2 or 5 times a power of ten, from at or below the least value
// to at or above the greatest ("loose" labels of Heckbert, "Nice numbers for graph labels",
// Graphics Gems, 1990); of such steps the finest that gives no more ticks than asked for.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "drawing/chart/chart.hpp"
#include "drawing/chart/chart_scale.hpp"

namespace reeve::drawing::chart {

struct Ticks {
  std::vector<double> values;  // ascending
  double step = 1;
};

// The extent has a length; `most` is at least 3, which a step
// always meets. `whole`: no step below 1.
Ticks nice_ticks(const Extent& extent, std::size_t most, bool whole = false);

// For an axis that is logarithmic beyond `linear_to`: 0 and 1, 3, 10, 30, … from there on, of both
// signs, as far as they lie within the extent. Those that matter most come first: 0, powers of ten,
// the rest.
std::vector<double> bent_ticks(const Extent& extent, double linear_to);

// With as many decimals as the step has.
std::string tick_text(double value, double step, Format format);
// With as many as the value itself needs.
std::string tick_text(double value, Format format);

}  // namespace reeve::drawing::chart
