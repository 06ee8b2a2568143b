// One panel with its frame, its axes and the texts round it, before anybody knows where in the
// picture it lies: the frame begins at (0, 0).
#pragma once

#include <vector>

#include "drawing/chart/chart.hpp"
#include "drawing/chart/chart_axis.hpp"
#include "drawing/chart/chart_text.hpp"

namespace reeve::drawing::chart {

struct LaidPanel {
  const Panel* panel = nullptr;
  Box frame;
  LaidAxis x;
  LaidAxis y;
  bool numbers_at_y = true;
  std::vector<ChartText> texts;  // title, ticks, titles of the axes
};

struct PanelFrame {
  double width = 0;
  double height = 0;
  Extent x;  // of numbers; they have lengths
  Extent y;
  bool numbers_at_y = true;  // otherwise another panel of the row has them
};

// Keeps a pointer to the panel.
LaidPanel lay_panel(const Panel& panel, const PanelFrame& frame);

void shift(LaidPanel& panel, double dx, double dy);

// Round the frame and all texts.
Box bounds(const LaidPanel& panel);

}  // namespace reeve::drawing::chart
