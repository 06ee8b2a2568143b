#include "drawing/schematic/schematic_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.hpp"
#include "drawing/schematic/schematic_symbols.hpp"
#include "drawing/svg.hpp"

namespace reeve::drawing {
namespace {

using namespace measures;

// Okabe and Ito's colours, which people with any colour vision tell apart; the darker ones first.
constexpr std::array<const char*, 6> tendon_colours{"#0072b2", "#d55e00", "#009e73",
                                                    "#cc79a7", "#56b4e9", "#e69f00"};

std::string tension_text(double tension) {
  constexpr double least_shown = 0.005;
  if (tension == 0) return "0";
  if (tension < least_shown) return "<.01";
  if (tension < 9.995) return fixed(tension, 2);
  return tension < 999.5 ? fixed(tension, 0) : fmt::format("{:.0e}", tension);
}

// Tension of a line of full width: the motor tension, or more if friction makes a strand pull
// harder than the motor during release.
double full_tension(const Schematic& schematic) {
  double most = 1;
  if (schematic.state == nullptr) return most;
  for (const double tension : schematic.state->tension) most = std::max(most, tension);
  return most;
}

// The cross-section in proportion to the tension: a rope under the same stress everywhere.
double line_width(double share) { return std::max(1.2, thickest * std::sqrt(share)); }

std::string tendon(const DrawnSegment& segment, const double* tension, double full) {
  const double width = tension == nullptr ? 2.5 : line_width(*tension / full);
  const bool slack = tension != nullptr && *tension == 0;
  return svg::path(
      svg::rounded(segment.path),
      " class=\"reeve-tendon\"" + svg::attribute("data-segment", segment.name) +
          svg::attribute("stroke", tendon_colours[segment.tendon % tendon_colours.size()]) +
          svg::attribute("stroke-width", svg::number(width)) +
          (slack ? " stroke-dasharray=\"5 4\"" : ""));
}

std::string label(const DrawnSegment& segment, const double* tension) {
  const Box& box = segment.label;
  const double x = svg::anchor(box, segment.align);
  const double baseline = box.top + 0.8 * line_height;
  std::string content = "<tspan font-weight=\"bold\">" + segment.name + "</tspan>";
  if (tension != nullptr) {
    content += "<tspan" + svg::attribute("x", svg::number(x)) +
               svg::attribute("dy", svg::number(line_height)) + ">" +
               svg::escape(tension_text(*tension)) + "</tspan>";
  }
  return "<text" + svg::attribute("x", svg::number(x)) +
         svg::attribute("y", svg::number(baseline)) +
         svg::attribute("font-size", svg::number(text_size)) + svg::anchor(segment.align) + ">" +
         content + "</text>\n";
}

std::string turns(const SchematicLayout& layout) {
  std::string content;
  for (const DrawnContact& contact : layout.contacts) {
    if (contact.place == ContactPlace::sheath) continue;
    if (contact.kind == ContactKind::bar) continue;
    content += contact.kind == ContactKind::tube
                   ? symbols::tube(contact, sleeve)
                   : symbols::wheel(contact.centre, contact.radius - thickest / 2 - 1);
  }
  return content;
}

std::string sheaths(const SchematicLayout& layout) {
  std::string content;
  for (const DrawnContact& contact : layout.contacts) {
    if (contact.place == ContactPlace::sheath) content += symbols::sheath(contact, sleeve);
  }
  return content;
}

std::string ends(const SchematicLayout& layout) {
  std::string content;
  for (const DrawnEnd& end : layout.ends) {
    switch (end.hold) {
      case EndHold::fixed:
        content += symbols::fixation(end, fixation_width, fixation_depth);
        break;
      case EndHold::tied:
        content += symbols::knot(end.at, knot_size);
        break;
      case EndHold::anchored:
        content += symbols::anchor(end.at, knot_size / 2);
        break;
      case EndHold::extensor:
        content += symbols::extensor(end.at, knot_size / 2);
        break;
      case EndHold::block:
        break;
    }
  }
  return content;
}

std::string arrows(const Schematic& schematic) {
  std::string content;
  if (schematic.state == nullptr) return content;
  for (std::size_t i = 0; i < schematic.layout.contacts.size(); ++i) {
    const double slip = schematic.state->slip[i];
    if (slip == 0) continue;
    content += svg::group(" class=\"reeve-slides\"",
                          symbols::sliding(schematic.layout.contacts[i], slip > 0));
  }
  return content;
}

// Draws the directions in which blocks and bars move.
std::string motions(const Schematic& schematic) {
  std::string content;
  if (schematic.state == nullptr) return content;
  // A state has the travel of a release as it would be pulled.
  const double way = schematic.direction == Direction::pull ? 1 : -1;
  for (std::size_t i = 0; i < schematic.layout.blocks.size(); ++i) {
    const DrawnBlock& block = schematic.layout.blocks[i];
    const double travel = way * schematic.state->block_travel[i] * block.apex;
    if (travel == 0) continue;
    const double x = (block.motion.left + block.motion.right) / 2;
    Point from{x, block.motion.top};
    Point to{x, block.motion.bottom};
    if (travel < 0) std::swap(from, to);
    content += svg::group(" class=\"reeve-moves\"", symbols::straight_arrow(from, to));
  }
  return content;
}

std::string held_fingers(const SchematicLayout& layout) {
  std::string content;
  for (const DrawnFinger& finger : layout.fingers) {
    if (finger.held) content += symbols::object(finger.object) + symbols::hatching(finger.outline);
  }
  return content;
}

// "motor 1.00"; of several, "motor 2, travel -1: 0.18".
std::string motor_text(const Schematic& schematic, int motor) {
  const bool several = schematic.layout.carriages.size() > 1;
  std::string text = several ? fmt::format("motor {}", motor) : "motor";
  if (schematic.state == nullptr) return text;
  if (!several) return text + " 1.00";
  const auto at = static_cast<std::size_t>(motor) - 1;
  if (schematic.carriages.given > 0) {
    text += fmt::format(", travel {:.3g}:", schematic.carriages.over_D[at]);
  }
  return text + " " + tension_text(schematic.motor_tension[at]);
}

std::string carriage(const Schematic& schematic, const DrawnCarriage& carriage) {
  const double x = (carriage.arrow.left + carriage.arrow.right) / 2;
  const double travel = schematic.carriages.over_D[static_cast<std::size_t>(carriage.motor) - 1];
  Point from{x, carriage.arrow.top};
  Point to{x, carriage.arrow.bottom};
  if ((schematic.direction == Direction::release) != (travel < 0)) std::swap(from, to);
  DrawnText text = carriage.text;
  text.text = motor_text(schematic, carriage.motor);
  const std::string arrow =
      travel == 0 ? "" : svg::group(" stroke-width=\"3\"", symbols::straight_arrow(from, to));
  return svg::group(symbols::strokes,
                    svg::rectangle(carriage.box, 6, " class=\"reeve-carriage\" fill=\"#e2e6ea\"") +
                        arrow) +
         svg::text(text);
}

std::string tendons(const Schematic& schematic) {
  const double full = full_tension(schematic);
  std::string lines;
  std::string labels;
  for (std::size_t i = 0; i < schematic.layout.segments.size(); ++i) {
    const double* tension = schematic.state == nullptr ? nullptr : &schematic.state->tension[i];
    lines += tendon(schematic.layout.segments[i], tension, full);
    labels += label(schematic.layout.segments[i], tension);
  }
  return svg::group(" fill=\"none\"", lines) + labels;
}

std::string draw(const Schematic& schematic) {
  const SchematicLayout& layout = schematic.layout;
  const auto draw_carriage = [&](const DrawnCarriage& drawn) { return carriage(schematic, drawn); };
  // Shells are behind the sheaves, eyes over the tendons that are tied there.
  const std::string shells = svg::each(layout.blocks, symbols::shell);
  const std::string eyes = svg::each(layout.blocks, symbols::eyes);
  return svg::group(symbols::strokes, symbols::hand(layout) + held_fingers(layout)) +
         svg::each(layout.carriages, draw_carriage) +
         svg::group(symbols::strokes, shells + turns(layout)) + tendons(schematic) +
         svg::group(symbols::strokes, sheaths(layout) + eyes + ends(layout) + arrows(schematic) +
                                          motions(schematic)) +
         svg::each(layout.texts, svg::text) + symbols::legend(layout.legend);
}

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
  return std::ranges::find(state.tension, 0) != state.tension.end();
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
    text = fmt::format("finger{} {} held", held.size() > 1 ? "s" : "", fmt::join(held, ", "));
  } else if (fingers > 1) {
    text = "no finger held";
  }
  text += locked_words(view.grasp);
  if (text.starts_with(", ")) text.erase(0, 2);
  if (!text.empty()) text += ", ";
  text += view.direction == Direction::pull ? "pulling" : "releasing";
  if (view.state.jams && fingers > 0) text += "; jams: the carriage is blocked";
  return text;
}

}  // namespace

Schematic schematic(const Network& network, const std::string& title, bool with_legend) {
  return {layout(network, {title, "", {}, with_legend, false}), nullptr, Direction::pull, {}, {}};
}

Schematic schematic(const Network& network, const std::string& title, const GraspView& view,
                    bool with_legend) {
  return schematic(network, places(network), title, view, with_legend);
}

Schematic schematic(const Network& network, const Places& places, const std::string& title,
                    const GraspView& view, bool with_legend) {
  const SchematicFrame frame{
      title, subtitle(view, network.fingers), view.grasp, with_legend, true, has_slack(view.state)};
  return {layout(network, frame, places), &view.state, view.direction, view.grasp.carriages,
          motor_tensions(network, view.state)};
}

std::string schematic_svg(const Schematic& schematic, const std::string& ids) {
  const SchematicLayout& layout = schematic.layout;
  return file({0, 0, layout.width, layout.height}, "img", ids, layout.title, description(schematic),
              draw(schematic));
}

std::string schematic_legend(double width, const std::string& ids, const DrawnParts& parts) {
  const Legend key = legend({margin, 0, width - margin, 0}, true, parts);
  return file({0, 0, width, key.bottom + margin / 2}, "img", ids, "Symbols",
              "What the symbols of the schematics mean.", symbols::legend(key));
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
  const bool with_tension =
      std::ranges::any_of(schematics, [](const Schematic& s) { return s.state != nullptr; });
  DrawnParts parts;
  for (const Schematic& schematic : schematics) {
    parts |= schematic.layout.parts;
    parts.slack = parts.slack || (schematic.state != nullptr && has_slack(*schematic.state));
  }
  const Legend key = legend({margin, bottom, right - margin, 0}, with_tension, parts);
  return file({0, 0, right, key.bottom + margin / 2}, "group", ids, title, "",
              content + symbols::legend(key));
}

}  // namespace reeve::drawing
