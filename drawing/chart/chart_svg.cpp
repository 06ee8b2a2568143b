#include "drawing/chart/chart_svg.hpp"

#include <fmt/format.h>

#include "drawing/chart/chart_drawing.hpp"
#include "drawing/chart/chart_layout.hpp"
#include "drawing/svg.hpp"

namespace reeve::drawing {
namespace chart {
namespace {

const std::string grid_style = " class=\"reeve-grid\" fill=\"none\" stroke=\"#dddddd\"";

std::string grid(const LaidPanel& laid) {
  std::string lines;
  if (laid.panel->x.grid && !laid.panel->x.hidden) {
    for (const Tick& tick : laid.x.ticks) {
      lines += svg::move_to({tick.at, laid.frame.top}) + svg::line_to({tick.at, laid.frame.bottom});
    }
  }
  if (laid.panel->y.grid && !laid.panel->y.hidden) {
    for (const Tick& tick : laid.y.ticks) {
      lines += svg::move_to({laid.frame.left, tick.at}) + svg::line_to({laid.frame.right, tick.at});
    }
  }
  return lines.empty() ? "" : svg::path(lines, grid_style);
}

// Short lines outside the frame.
std::string ticks(const LaidPanel& laid) {
  constexpr double length = 4;
  std::string lines;
  if (!laid.panel->x.hidden) {
    for (const Tick& tick : laid.x.ticks) {
      lines += svg::move_to({tick.at, laid.frame.bottom}) +
               svg::line_to({tick.at, laid.frame.bottom + length});
    }
  }
  if (!laid.panel->y.hidden && laid.numbers_at_y) {
    for (const Tick& tick : laid.y.ticks) {
      lines += svg::move_to({laid.frame.left - length, tick.at}) +
               svg::line_to({laid.frame.left, tick.at});
    }
  }
  return lines.empty() ? "" : svg::path(lines, " fill=\"none\" stroke=\"#808080\"");
}

std::string texts(const std::vector<ChartText>& texts) {
  std::string all;
  for (const ChartText& text : texts) all += draw(text);
  return all;
}

std::string panel(const LaidPanel& laid, const std::vector<LaidLabel>& labels) {
  std::string content = grid(laid);
  content += svg::rectangle(laid.frame, 0, " fill=\"none\" stroke=\"#a0a0a0\"");
  for (const Layer& layer : laid.panel->layers) content += draw(layer, laid);
  std::string names;
  for (const LaidLabel& label : labels) names += draw(label);
  content += svg::group(" class=\"reeve-labels\"", names);
  content += svg::group(" class=\"reeve-axes\"", ticks(laid) + texts(laid.texts));
  return svg::group(" class=\"reeve-panel\"", content);
}

std::string content(const ChartLayout& laid) {
  std::string content = texts(laid.headings);
  for (std::size_t i = 0; i < laid.panels.size(); ++i)
    content += panel(laid.panels[i], laid.labels[i]);
  std::string legend;
  for (const LegendEntry& entry : laid.legend) legend += draw(entry);
  return content + svg::group(" class=\"reeve-legend\"", legend);
}

}  // namespace
}  // namespace chart

std::string chart_svg(const chart::Chart& chart) {
  const chart::ChartLayout laid = layout(chart);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"reeve-chart\" role=\"img\" "
      "aria-label=\"{2}\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" color=\"#1a1a1a\" "
      "fill=\"currentColor\" font-family=\"Helvetica, Arial, sans-serif\">\n{3}{4}</svg>\n",
      svg::number(laid.width), svg::number(laid.height), svg::escape(chart.alt),
      svg::rectangle({0, 0, laid.width, laid.height}, 0, " class=\"reeve-paper\" fill=\"#ffffff\""),
      chart::content(laid));
}

}  // namespace reeve::drawing
