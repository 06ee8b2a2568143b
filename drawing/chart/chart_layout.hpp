// The geometry of a chart: where everything lies, in pixels, y downward. No text overlaps another,
// and all lies within the chart.
#pragma once

#include <vector>

#include "drawing/chart/chart.hpp"
#include "drawing/chart/chart_axis.hpp"
#include "drawing/chart/chart_text.hpp"

namespace reeve::drawing::chart {

// A panel with its frame, its axes and the texts round it.
struct LaidPanel {
  const Panel* panel = nullptr;
  Box frame;
  LaidAxis x;
  LaidAxis y;
  bool numbers_at_y = true;
  std::vector<ChartText> texts;  // title, ticks, titles of the axes
};

struct LegendEntry {
  std::vector<const Layer*> layers;  // layers whose symbols lie over each other
  Box symbol;
  ChartText text;
};

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

// Place of a spot of this panel.
Point place(const LaidPanel& panel, double x, double y);

// The following functions handle one panel, before its place in the chart is known
// (chart_panel.cpp).

// Returns the extent of all marks of the panel that can be drawn, and of the axis' own `reaches`.
// If both axes have one scale, it covers both. Categories extend half a category on both sides of
// their place.
Extent extent(const Panel& panel, Along along);

// Returns an extent of a length greater than 0, for any marks. It stays within the possible values
// unless marks lie beyond them.
Extent widened(const Axis& axis, const Extent& marks);

const Axis& axis(const Panel& panel, Along along);

struct PanelFrame {
  double width = 0;
  double height = 0;
  Extent x;  // range of numbers, of a length above 0
  Extent y;
  bool numbers_at_y = true;  // otherwise another panel of the row has them
};

// Keeps a pointer to the panel.
LaidPanel lay_panel(const Panel& panel, const PanelFrame& frame);

void shift(LaidPanel& panel, double dx, double dy);

// Round the frame and all texts.
Box bounds(const LaidPanel& panel);

}  // namespace reeve::drawing::chart
