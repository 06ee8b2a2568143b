// An objective as an axis of a chart.
#pragma once

#include <string>

#include "drawing/chart/chart.hpp"
#include "search/evaluate/objectives.hpp"

namespace reeve::pages {

// Named with its unit and which way is better; no longer than what the objective can be.
chart::Axis objective_axis(Objective objective, const std::string& cost_unit = "");

}  // namespace reeve::pages
