// Draws a chart as a file of SVG, on white.
//
// A page that inlines it may restyle the classes reeve-chart (its `color` is the ink), reeve-paper,
// reeve-grid and those of chart_colours.hpp: colours are attributes, which any style overrides.
// Marks are the elements inside reeve-points, reeve-bars, reeve-spans, reeve-paths, reeve-bands and
// reeve-rules; data-series says which series a group shows. No identifiers are in it, so a page can
// hold several.
#pragma once

#include <string>

#include "drawing/chart/chart.hpp"

namespace reeve::drawing {

std::string chart_svg(const chart::Chart& chart);

}  // namespace reeve::drawing
