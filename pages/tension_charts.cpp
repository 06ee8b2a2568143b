#include "pages/tension_charts.hpp"

#include <algorithm>

#include "pages/routing_parts.hpp"

namespace reeve {
namespace {

constexpr double figure_width = 900;
constexpr double panel_gap = 24;

std::size_t strand_count(const TensionPanel& panel) {
  return 2 * static_cast<std::size_t>(panel.network->fingers);
}

}  // namespace

double panel_width(std::size_t bars) {
  return std::clamp(26 * static_cast<double>(bars), 60.0, 600.0);
}

Json in_rows(Json spec, double panel_width, std::size_t panels) {
  const double room = panel_width + panel_gap;
  const auto in_figure = static_cast<std::size_t>(figure_width / room);
  spec["columns"] = std::clamp<std::size_t>(panels, 1, std::max<std::size_t>(1, in_figure));
  spec["usermeta"] = {{"panel_px", room}};
  return spec;
}

Json tension_spec(const std::vector<TensionPanel>& panels) {
  Json values = Json::array();
  Json titles = Json::array();
  for (const TensionPanel& panel : panels) {
    titles.push_back(panel.title);
    for (const auto& [segment, tension] : strands(*panel.network, *panel.state)) {
      values.push_back({{"panel", panel.title},
                        {"strand", name(segment)},
                        {"finger", std::to_string(segment.finger)},
                        {"tension", number(tension)}});
    }
  }
  const double width = panels.empty() ? 0 : panel_width(strand_count(panels.front()));
  Json x{{"field", "strand"}, {"type", "nominal"}, {"sort", nullptr}, {"title", nullptr}};
  x["axis"] = {{"labelAngle", 0}, {"labelOverlap", true}};
  const Json y{
      {"field", "tension"}, {"type", "quantitative"}, {"title", {"tension over", "motor tension"}}};
  const Json color{{"field", "finger"}, {"type", "nominal"}, {"sort", nullptr}};
  Json spec{{"data", {{"values", values}}}};
  spec["facet"] = {{"field", "panel"}, {"type", "nominal"}, {"sort", titles}, {"title", nullptr}};
  spec["facet"]["header"] = {{"labelLimit", width + panel_gap}};
  spec["spec"] = {{"width", width},
                  {"height", 120},
                  {"mark", {{"type", "bar"}, {"tooltip", true}}},
                  {"encoding", {{"x", x}, {"y", y}, {"color", color}}}};
  return in_rows(spec, width, panels.size());
}

Json tension_spec(const ShowReport& report) {
  std::vector<TensionPanel> panels;
  for (const ShownGrasp& shown : report.grasps) {
    panels.push_back({grasp_words(shown.grasp), &report.network, &shown.state});
  }
  return tension_spec(panels);
}

}  // namespace reeve
