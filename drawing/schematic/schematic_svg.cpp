#include "drawing/schematic/schematic_svg.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "drawing/schematic/schematic_drawing.hpp"
#include "drawing/schematic/schematic_measures.hpp"
#include "drawing/svg.hpp"

namespace reeve::drawing {
namespace {

std::string description(const Schematic& schematic) {
  std::string text = schematic.layout.subtitle;
  if (schematic.state == nullptr) return text;
  text += ". Tensions:";
  for (std::size_t i = 0; i < schematic.layout.segments.size(); ++i) {
    text += fmt::format(" {} {}", schematic.layout.segments[i].name,
                        fixed(schematic.state->tension[i]));
  }
  return text;
}

bool has_slack(const TensionState& state) {
  return std::find(state.tension.begin(), state.tension.end(), 0) != state.tension.end();
}

// `role`: an image is one thing to a screen reader, a group has things inside.
std::string file(const Box& page, const char* role, const std::string& ids,
                 const std::string& title, const std::string& description,
                 const std::string& content) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"reeve-schematic\" role=\"{7}\" "
      "aria-labelledby=\"{0}-title {0}-desc\" viewBox=\"0 0 {1} {2}\" width=\"{1}\" "
      "height=\"{2}\" color=\"#1a1a1a\" fill=\"currentColor\" "
      "font-family=\"Helvetica, Arial, sans-serif\">\n"
      "<title id=\"{0}-title\">{3}</title>\n<desc id=\"{0}-desc\">{4}</desc>\n{5}{6}</svg>\n",
      svg::escape(ids), svg::number(page.right), svg::number(page.bottom), svg::escape(title),
      svg::escape(description), svg::rectangle(page, 0, " class=\"reeve-paper\" fill=\"#ffffff\""),
      content, role);
}

// Without fingers nothing is to be held back, and jam says nothing. With one, nothing else moves.
std::string subtitle(const GraspView& view, int fingers) {
  const std::vector<int> held = held_fingers(view.grasp);
  std::string text;
  if (!held.empty()) {
    text = fmt::format("finger{} {} held, ", held.size() > 1 ? "s" : "", fmt::join(held, ", "));
  } else if (fingers > 1) {
    text = "no finger held, ";
  }
  text += view.direction == Direction::pull ? "pulling" : "releasing";
  if (view.state.jams && fingers > 0) text += "; jams: the carriage is blocked";
  return text;
}

}  // namespace

Schematic schematic(const Network& network, const std::string& title, bool with_legend) {
  return {layout(network, {title, "", {}, with_legend, false}), nullptr, Direction::pull};
}

Schematic schematic(const Network& network, const std::string& title, const GraspView& view,
                    bool with_legend) {
  return schematic(network, layout_plan(network), title, view, with_legend);
}

Schematic schematic(const Network& network, const LayoutPlan& plan, const std::string& title,
                    const GraspView& view, bool with_legend) {
  const SchematicFrame frame{
      title, subtitle(view, network.fingers), view.grasp, with_legend, true, has_slack(view.state)};
  return {layout(network, frame, plan), &view.state, view.direction};
}

std::string schematic_svg(const Schematic& schematic, const std::string& ids) {
  const SchematicLayout& layout = schematic.layout;
  return file({0, 0, layout.width, layout.height}, "img", ids, layout.title, description(schematic),
              draw(schematic));
}

std::string schematic_legend(double width, const std::string& ids, const DrawnParts& parts) {
  const Legend key = legend({measures::margin, 0, width - measures::margin, 0}, true, parts);
  return file({0, 0, width, key.bottom + measures::margin / 2}, "img", ids, "Symbols",
              "What the symbols of the schematics mean.", draw(key));
}

std::string schematic_sheet(const std::vector<Schematic>& schematics, std::size_t columns,
                            const std::string& title, const std::string& ids) {
  double width = 0;
  for (const Schematic& schematic : schematics) width = std::max(width, schematic.layout.width);
  std::string content;
  double top = 0;
  double bottom = 0;
  for (std::size_t i = 0; i < schematics.size(); ++i) {
    if (i % columns == 0) top = bottom;
    const SchematicLayout& layout = schematics[i].layout;
    content += svg::group(
        fmt::format(" role=\"img\" aria-label=\"{}. {}\" transform=\"translate({} {})\"",
                    svg::escape(layout.title), svg::escape(description(schematics[i])),
                    svg::number(width * static_cast<double>(i % columns)), svg::number(top)),
        draw(schematics[i]));
    bottom = std::max(bottom, top + layout.height);
  }
  const double right = width * static_cast<double>(std::min(columns, schematics.size()));
  const bool with_tension = std::any_of(schematics.begin(), schematics.end(),
                                        [](const Schematic& s) { return s.state != nullptr; });
  DrawnParts parts;
  for (const Schematic& schematic : schematics) {
    parts |= schematic.layout.parts;
    parts.slack = parts.slack || (schematic.state != nullptr && has_slack(*schematic.state));
  }
  const Legend key =
      legend({measures::margin, bottom, right - measures::margin, 0}, with_tension, parts);
  return file({0, 0, right, key.bottom + measures::margin / 2}, "group", ids, title, "",
              content + draw(key));
}

}  // namespace reeve::drawing
