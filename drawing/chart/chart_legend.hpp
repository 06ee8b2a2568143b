// What the layers of a chart are called, below it.
#pragma once

#include <vector>

#include "drawing/chart/chart.hpp"
#include "drawing/chart/chart_text.hpp"

namespace reeve::drawing::chart {

struct LegendEntry {
  std::vector<const Layer*> layers;  // whose symbols lie over each other
  Box symbol;
  ChartText text;
};

// In the order in which the names come first, in rows from the left between the room's sides. Keeps
// pointers to the layers.
std::vector<LegendEntry> legend(const Chart& chart, const Box& room);

}  // namespace reeve::drawing::chart
