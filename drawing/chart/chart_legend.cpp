#include "drawing/chart/chart_legend.hpp"

#include <algorithm>

namespace reeve::drawing::chart {
namespace {

constexpr double symbol_width = 22;
constexpr double row_height = 20;
constexpr double before_text = 5;
constexpr double between = 16;

// Layers of one name and kind look alike; the first speaks for all.
void add(const Layer& layer, std::vector<LegendEntry>& entries) {
  if (layer.name.empty()) return;
  auto found = std::find_if(entries.begin(), entries.end(), [&](const LegendEntry& entry) {
    return entry.layers.front()->name == layer.name;
  });
  if (found == entries.end()) {
    entries.push_back({{&layer}, {}, {}});
    return;
  }
  const bool is_new =
      std::none_of(found->layers.begin(), found->layers.end(),
                   [&](const Layer* other) { return other->marks.index() == layer.marks.index(); });
  if (is_new) found->layers.push_back(&layer);
}

}  // namespace

std::vector<LegendEntry> legend(const Chart& chart, const Box& room) {
  std::vector<LegendEntry> entries;
  for (const Panel& panel : chart.panels) {
    for (const Layer& layer : panel.layers) add(layer, entries);
  }
  double x = room.left;
  double y = room.top;
  const double widest = room.right - room.left - symbol_width - before_text;
  for (LegendEntry& entry : entries) {
    const ChartText text = cut(entry.layers.front()->name, small_text, Weight::normal, widest);
    const double width = measures::text_width(text.drawn.text, small_text, false);
    if (x > room.left && x + symbol_width + before_text + width > room.right) {
      x = room.left;
      y += row_height;
    }
    entry.symbol = {x, y, x + symbol_width, y + row_height};
    x += symbol_width + before_text;
    entry.text = at(text, {x, y + (row_height - line_of(small_text)) / 2}, Align::start);
    x += width + between;
  }
  return entries;
}

}  // namespace reeve::drawing::chart
