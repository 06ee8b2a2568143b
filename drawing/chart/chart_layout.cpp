#include "drawing/chart/chart_layout.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::drawing::chart {
namespace {

constexpr double margin = 8;
constexpr double between_columns = 16;
constexpr double between_rows = 14;
constexpr double before_legend = 8;
constexpr double least_legend = 320;
constexpr double least_heading = 200;

struct PanelRow {
  std::size_t begin = 0;  // panels
  std::size_t end = 0;
  const std::string* heading = nullptr;
};

std::vector<PanelRow> rows(const Chart& chart) {
  const std::size_t columns = std::max<std::size_t>(chart.columns, 1);
  std::vector<PanelRow> result;
  for (std::size_t i = 0; i < chart.panels.size(); ++i) {
    const std::string& heading = chart.panels[i].heading;
    if (result.empty() || !heading.empty() || i - result.back().begin == columns) {
      result.push_back({i, i, heading.empty() ? nullptr : &heading});
    }
    ++result.back().end;
  }
  return result;
}

// Returns the extent of each panel; panels that share the scale have the extent of all.
std::vector<Extent> extents(const Chart& chart, Along along, bool shared) {
  std::vector<Extent> result;
  Extent all;
  for (const Panel& panel : chart.panels) {
    result.push_back(extent(panel, along));
    all.add(result.back());
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = widened(axis(chart.panels[i], along), shared ? all : result[i]);
  }
  return result;
}

std::vector<LaidPanel> lay_panels(const Chart& chart, const std::vector<PanelRow>& rows) {
  const std::vector<Extent> x = extents(chart, Along::x, chart.shared_x);
  const std::vector<Extent> y = extents(chart, Along::y, chart.shared_y);
  std::vector<LaidPanel> panels;
  for (const PanelRow& row : rows) {
    for (std::size_t i = row.begin; i < row.end; ++i) {
      const bool numbers_at_y = !chart.shared_y || i == row.begin;
      panels.push_back(
          lay_panel(chart.panels[i], {chart.width, chart.height, x[i], y[i], numbers_at_y}));
    }
  }
  return panels;
}

// Width beside the frames of each column, on the left and on the right, and the place of the
// frames.
struct ColumnPlace {
  double out_left = 0;
  double out_right = 0;
  double frame = 0;
};

std::vector<ColumnPlace> columns(const Chart& chart, const std::vector<PanelRow>& rows,
                                 const std::vector<LaidPanel>& panels) {
  std::vector<ColumnPlace> result;
  for (const PanelRow& row : rows) {
    for (std::size_t i = row.begin; i < row.end; ++i) {
      const std::size_t column = i - row.begin;
      if (column == result.size()) result.emplace_back();
      const Box box = bounds(panels[i]);
      result[column].out_left = std::max(result[column].out_left, -box.left);
      result[column].out_right = std::max(result[column].out_right, box.right - chart.width);
    }
  }
  double x = margin;
  for (ColumnPlace& column : result) {
    column.frame = x + column.out_left;
    x = column.frame + chart.width + column.out_right + between_columns;
  }
  return result;
}

// Adds a heading as wide as the panels, and no narrower than a few words. Returns the top of the
// panels.
double add_heading(const std::string& heading, double right, double top, ChartLayout& layout) {
  const double width = std::max(right - margin, least_heading);
  for (const ChartText& line : broken(heading, heading_text, Weight::bold, width, 3)) {
    layout.headings.push_back(at(line, {margin, top}, Align::start));
    top = layout.headings.back().drawn.box.bottom;
  }
  return top + 4;
}

// Moves the panels of a row, and says where the next may begin.
double put_row(const PanelRow& row, const std::vector<ColumnPlace>& columns, double width,
               double top, ChartLayout& layout) {
  const double right = columns[row.end - row.begin - 1].frame + width;
  if (row.heading != nullptr) top = add_heading(*row.heading, right, top, layout);
  double above = 0;
  for (std::size_t i = row.begin; i < row.end; ++i) {
    above = std::max(above, -bounds(layout.panels[i]).top);
  }
  double bottom = top;
  for (std::size_t i = row.begin; i < row.end; ++i) {
    shift(layout.panels[i], columns[i - row.begin].frame, top + above);
    bottom = std::max(bottom, bounds(layout.panels[i]).bottom);
  }
  return bottom + between_rows;
}

constexpr double symbol_width = 22;
constexpr double row_height = 20;
constexpr double before_text = 5;
constexpr double between = 16;

// Layers of one name and kind look alike; the first speaks for all.
void add_entry(const Layer& layer, std::vector<LegendEntry>& entries) {
  if (layer.name.empty()) return;
  auto found = std::ranges::find_if(
      entries, [&](const LegendEntry& entry) { return entry.layers.front()->name == layer.name; });
  if (found == entries.end()) {
    entries.push_back({{&layer}, {}, {}});
    return;
  }
  const bool is_new = std::ranges::none_of(found->layers, [&](const Layer* other) {
    return other->marks.index() == layer.marks.index();
  });
  if (is_new) found->layers.push_back(&layer);
}

// Lists names in the order in which they come first, in rows from the left between the room's
// sides. Keeps pointers to the layers.
std::vector<LegendEntry> legend(const Chart& chart, const Box& room) {
  std::vector<LegendEntry> entries;
  for (const Panel& panel : chart.panels) {
    for (const Layer& layer : panel.layers) add_entry(layer, entries);
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

void add_legend(const Chart& chart, ChartLayout& layout) {
  double left = margin;
  double right = 0;
  double bottom = margin;
  for (const LaidPanel& panel : layout.panels) {
    const Box box = bounds(panel);
    if (right == 0) left = panel.frame.left;
    right = std::max(right, box.right);
    bottom = std::max(bottom, box.bottom);
  }
  for (const ChartText& heading : layout.headings) {
    right = std::max(right, heading.drawn.box.right);
  }
  layout.legend =
      legend(chart, {left, bottom + before_legend, std::max(right, left + least_legend), 0});
  for (const LegendEntry& entry : layout.legend) {
    right = std::max(right, entry.text.drawn.box.right);
    bottom = std::max(bottom, entry.symbol.bottom);
  }
  layout.width = std::ceil(right + margin);
  layout.height = std::ceil(bottom + margin);
}

constexpr double widest = 0.45;  // share of the frame

struct Wanted {
  std::vector<WantedLabel> labels;
  std::vector<ChartText> texts;
  std::vector<Box> marks;
};

void want(const std::string& text, Point at, double radius, const Box& frame, Wanted& wanted) {
  const ChartText shown =
      cut(text, small_text, Weight::normal, widest * (frame.right - frame.left));
  wanted.labels.push_back(
      {at, radius, measures::text_width(shown.drawn.text, small_text, false), line_of(small_text)});
  wanted.texts.push_back(shown);
}

void add_points(const LaidPanel& panel, const Layer& layer, const Points& points, Wanted& wanted) {
  const double radius = layer.style.size;
  for (const Spot& spot : points.spots) {
    if (!can_be_drawn(spot)) continue;
    const Point at = place(panel, spot.x, spot.y);
    wanted.marks.push_back({at.x - radius, at.y - radius, at.x + radius, at.y + radius});
    if (!spot.label.empty()) want(spot.label, at, radius, panel.frame, wanted);
  }
}

// Just inside the frame, at the end where the rule leaves it.
void add_rules(const LaidPanel& panel, const Rules& rules, Wanted& wanted) {
  const double inside = line_of(small_text) / 2 + 2;
  for (const Level& rule : rules.rules) {
    if (!can_be_drawn(rule) || rule.label.empty()) continue;
    const Point at = rules.on == Along::x
                         ? Point{place(panel.x.scale, rule.at), panel.frame.top + inside}
                         : Point{panel.frame.right - inside, place(panel.y.scale, rule.at)};
    want(rule.label, at, 1, panel.frame, wanted);
  }
}

// Finds both ends of the line from the mark to its text.
LaidLabel laid(ChartText text, const WantedLabel& wanted, const PlacedLabel& placed) {
  const Box& box = placed.box;
  text.drawn.box = box;
  LaidLabel label{std::move(text), placed.needs_leader, wanted.at, {}};
  label.to = {std::clamp(wanted.at.x, box.left, box.right),
              std::clamp(wanted.at.y, box.top, box.bottom)};
  const double length = std::hypot(label.to.x - wanted.at.x, label.to.y - wanted.at.y);
  if (length > 0) {
    const double share = std::min(1.0, (wanted.radius + 1) / length);
    label.from = {wanted.at.x + share * (label.to.x - wanted.at.x),
                  wanted.at.y + share * (label.to.y - wanted.at.y)};
  }
  return label;
}

// Lays the labels of spots and rules, as far as there is room. The panel is already in its final
// place.
std::vector<LaidLabel> mark_labels(const LaidPanel& panel) {
  Wanted wanted;
  for (const Layer& layer : panel.panel->layers) {
    if (const auto* points = std::get_if<Points>(&layer.marks)) {
      add_points(panel, layer, *points, wanted);
    } else if (const auto* rules = std::get_if<Rules>(&layer.marks)) {
      add_rules(panel, *rules, wanted);
    }
  }
  const auto placed = place_labels(wanted.labels, wanted.marks, panel.frame);
  std::vector<LaidLabel> labels;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (placed[i]) labels.push_back(laid(wanted.texts[i], wanted.labels[i], *placed[i]));
  }
  return labels;
}

}  // namespace

ChartLayout layout(const Chart& chart) {
  const std::vector<PanelRow> all_rows = rows(chart);
  ChartLayout layout;
  layout.panels = lay_panels(chart, all_rows);
  const std::vector<ColumnPlace> places = columns(chart, all_rows, layout.panels);
  double top = margin;
  for (const PanelRow& row : all_rows) top = put_row(row, places, chart.width, top, layout);
  for (const LaidPanel& panel : layout.panels) layout.labels.push_back(mark_labels(panel));
  add_legend(chart, layout);
  return layout;
}

Point place(const LaidPanel& panel, double x, double y) {
  return {place(panel.x.scale, x), place(panel.y.scale, y)};
}

}  // namespace reeve::drawing::chart
