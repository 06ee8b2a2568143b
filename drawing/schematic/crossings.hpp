// How good an arrangement of a drawing with floating parts is.
#pragma once

#include "drawing/schematic/columns.hpp"

namespace reeve::drawing {

// More than anything else in the cost of a hand of this size.
inline constexpr double cost_of_crossing = 10000;

// Little: few crossings, first of all; then short level stretches, and a narrow drawing.
double cost(const Fittings& all, const Lanes& lanes, const FloatingHeights& heights,
            const Columns& columns);

}  // namespace reeve::drawing
