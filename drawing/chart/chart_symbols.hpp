// The symbols of points, each about as large to the eye as a circle of the same size, with its
// centre of gravity where the point lies.
#pragma once

#include <string>

#include "drawing/chart/chart.hpp"

namespace reeve::drawing::chart {

// The element of a symbol round a place, but for its end: "<circle … r="4"" or "<path d="…"".
std::string symbol(Symbol kind, Point at, double size);

}  // namespace reeve::drawing::chart
