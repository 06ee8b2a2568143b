#include "drawing/chart/chart_layout.hpp"

#include <algorithm>
#include <cmath>

#include "drawing/chart/chart_extent.hpp"
#include "drawing/chart/chart_mark_labels.hpp"

namespace reeve::drawing::chart {
namespace {

constexpr double margin = 8;
constexpr double between_columns = 16;
constexpr double between_rows = 14;
constexpr double before_legend = 8;
constexpr double least_legend = 320;
constexpr double least_heading = 200;

struct Row {
  std::size_t begin = 0;  // panels
  std::size_t end = 0;
  const std::string* heading = nullptr;
};

std::vector<Row> rows(const Chart& chart) {
  const std::size_t columns = std::max<std::size_t>(chart.columns, 1);
  std::vector<Row> result;
  for (std::size_t i = 0; i < chart.panels.size(); ++i) {
    const std::string& heading = chart.panels[i].heading;
    if (result.empty() || !heading.empty() || i - result.back().begin == columns) {
      result.push_back({i, i, heading.empty() ? nullptr : &heading});
    }
    ++result.back().end;
  }
  return result;
}

// Of all panels together where they share the scale.
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

std::vector<LaidPanel> lay_panels(const Chart& chart, const std::vector<Row>& rows) {
  const std::vector<Extent> x = extents(chart, Along::x, chart.shared_x);
  const std::vector<Extent> y = extents(chart, Along::y, chart.shared_y);
  std::vector<LaidPanel> panels;
  for (const Row& row : rows) {
    for (std::size_t i = row.begin; i < row.end; ++i) {
      const bool numbers_at_y = !chart.shared_y || i == row.begin;
      panels.push_back(
          lay_panel(chart.panels[i], {chart.width, chart.height, x[i], y[i], numbers_at_y}));
    }
  }
  return panels;
}

// What stands out of the frames of each column, on the left and on the right; so do frames' places.
struct ColumnPlace {
  double out_left = 0;
  double out_right = 0;
  double frame = 0;
};

std::vector<ColumnPlace> columns(const Chart& chart, const std::vector<Row>& rows,
                                 const std::vector<LaidPanel>& panels) {
  std::vector<ColumnPlace> result;
  for (const Row& row : rows) {
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

// As wide as the panels, and no narrower than a few words; returns where they may begin.
double add_heading(const std::string& heading, double right, double top, ChartLayout& layout) {
  const double width = std::max(right - margin, least_heading);
  for (const ChartText& line : broken(heading, heading_text, Weight::bold, width, 3)) {
    layout.headings.push_back(at(line, {margin, top}, Align::start));
    top = layout.headings.back().drawn.box.bottom;
  }
  return top + 4;
}

// Moves the panels of a row, and says where the next may begin.
double put_row(const Row& row, const std::vector<ColumnPlace>& columns, double width, double top,
               ChartLayout& layout) {
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

}  // namespace

ChartLayout layout(const Chart& chart) {
  const std::vector<Row> all_rows = rows(chart);
  ChartLayout layout;
  layout.panels = lay_panels(chart, all_rows);
  const std::vector<ColumnPlace> places = columns(chart, all_rows, layout.panels);
  double top = margin;
  for (const Row& row : all_rows) top = put_row(row, places, chart.width, top, layout);
  for (const LaidPanel& panel : layout.panels) layout.labels.push_back(mark_labels(panel));
  add_legend(chart, layout);
  return layout;
}

Point place(const LaidPanel& panel, double x, double y) {
  return {place(panel.x.scale, x), place(panel.y.scale, y)};
}

}  // namespace reeve::drawing::chart
