// The geometry of a chart: where everything lies, in pixels, y downward. No text overlaps another,
// and all lies within the picture. chart_svg.hpp draws it.
#pragma once

#include <vector>

#include "drawing/chart/chart.hpp"
#include "drawing/chart/chart_legend.hpp"
#include "drawing/chart/chart_panel.hpp"

namespace reeve::drawing::chart {

// The text of a mark, and the line from the mark to it where it stands apart.
struct LaidLabel {
  ChartText text;
  bool has_leader = false;
  Point from;
  Point to;
};

struct ChartLayout {
  double width = 0;
  double height = 0;
  std::vector<LaidPanel> panels;
  std::vector<std::vector<LaidLabel>> labels;  // parallel to the panels
  std::vector<ChartText> headings;
  std::vector<LegendEntry> legend;
};

// Keeps pointers into the chart.
ChartLayout layout(const Chart& chart);

// Where a spot of this panel lies.
Point place(const LaidPanel& panel, double x, double y);

}  // namespace reeve::drawing::chart
