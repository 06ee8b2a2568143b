#include "pages/tension_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/text.hpp"
#include "pages/routing_parts.hpp"

namespace reeve::pages {
namespace {

constexpr double figure_width = 900;
constexpr double panel_gap = 24;

// A layer for each finger, in the colour that it has in each panel.
std::vector<chart::Layer> layers(const std::vector<std::pair<Segment, double>>& tensions) {
  std::map<int, chart::Bars> bars;
  for (std::size_t i = 0; i < tensions.size(); ++i) {
    const auto& [segment, tension] = tensions[i];
    bars[segment.finger].bars.push_back(
        {static_cast<double>(i), tension, segment_name(segment) + ": " + fixed(tension), ""});
  }
  std::vector<chart::Layer> result;
  for (const auto& [finger, of_finger] : bars) {
    chart::Style style;
    style.colour = chart::series_colour(static_cast<std::size_t>(std::max(finger - 1, 0)));
    result.push_back({fmt::format("finger {}", finger), style, of_finger});
  }
  return result;
}

}  // namespace

double panel_width(std::size_t bars) {
  return std::clamp(26 * static_cast<double>(bars), 60.0, 600.0);
}

std::size_t columns(double panel_width, std::size_t panels) {
  const auto in_figure = static_cast<std::size_t>(figure_width / (panel_width + panel_gap));
  return std::clamp<std::size_t>(panels, 1, std::max<std::size_t>(1, in_figure));
}

chart::Chart tension_chart(const std::vector<TensionPanel>& panels) {
  chart::Chart result;
  for (const TensionPanel& given : panels) {
    const auto tensions = strands(*given.network, *given.state);
    chart::Panel panel;
    panel.title = given.title;
    result.alt += " " + given.title + ":";
    for (const auto& [segment, tension] : tensions) {
      panel.x.categories.push_back(segment_name(segment));
      result.alt += " " + segment_name(segment) + " " + fixed(tension);
    }
    result.alt += ".";
    panel.x.grid = false;
    panel.y.title = "tension over motor tension";
    panel.y.least = 0;
    panel.layers = layers(tensions);
    result.panels.push_back(std::move(panel));
  }
  result.width = panels.empty() ? 0 : panel_width(result.panels.front().x.categories.size());
  result.height = 120;
  result.columns = columns(result.width, panels.size());
  result.shared_y = true;
  return result;
}

chart::Chart tension_chart(const SolvedRouting& report) {
  std::vector<TensionPanel> panels;
  for (const ShownGrasp& shown : report.grasps) {
    panels.push_back({grasp_words(shown.grasp), &report.network, &shown.state});
  }
  return tension_chart(panels);
}

}  // namespace reeve::pages
