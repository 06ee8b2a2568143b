// How far the axes of a panel have to reach.
#pragma once

#include "drawing/chart/chart.hpp"
#include "drawing/chart/chart_scale.hpp"

namespace reeve::drawing::chart {

// Over all marks of the panel that can be drawn, and the axis' own `reaches`; over both axes where
// they have one scale. Categories are wide: half of one on both sides of its place.
Extent extent(const Panel& panel, Along along);

// With a length greater than 0 whatever the marks are, and within what is possible unless marks lie
// beyond that.
Extent widened(const Axis& axis, const Extent& marks);

// Room that stays free at the ends of an axis, px, so that no symbol leaves the frame: half the
// largest one, of which categories have their share. Bars stand on the frame.
struct Inset {
  double low = 0;
  double high = 0;
};
Inset inset(const Panel& panel, Along along, double length);

const Axis& axis(const Panel& panel, Along along);

}  // namespace reeve::drawing::chart
