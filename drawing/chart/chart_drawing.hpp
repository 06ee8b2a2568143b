// What is inside a chart's file: the marks of a layer, and their symbols in the legend.
#pragma once

#include <string>

#include "drawing/chart/chart_layout.hpp"

namespace reeve::drawing::chart {

// A group with one element for each mark.
std::string draw(const Layer& layer, const LaidPanel& panel);

std::string draw(const LegendEntry& entry);

std::string draw(const ChartText& text);

// Of a text that stands apart from its mark, the line to it too.
std::string draw(const LaidLabel& label);

}  // namespace reeve::drawing::chart
