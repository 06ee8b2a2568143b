#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "drawing/chart/chart_layout.hpp"
#include "drawing/svg.hpp"

namespace reeve::drawing {
namespace chart {
namespace {

using svg::attribute;

// " reeve-blue", to follow another class.
std::string colour_class(Colour colour) {
  return std::string(" reeve-") + colours[static_cast<std::size_t>(colour)].name;
}

// " color="#0072b2"", which `currentColor` then means; ink is what the chart has.
std::string colour_attribute(Colour colour) {
  if (colour == Colour::ink) return "";
  return attribute("color", colours[static_cast<std::size_t>(colour)].on_white);
}

// A closed line through places given as multiples of the size.
std::string outline(Point at, double size, const std::vector<Point>& corners) {
  std::string commands;
  for (const Point& corner : corners) {
    commands += commands.empty() ? 'M' : 'L';
    commands += svg::number(at.x + size * corner.x);
    commands += ' ';
    commands += svg::number(at.y + size * corner.y);
  }
  return "<path d=\"" + commands + "Z\"";
}

// The symbols of points, each about as large to the eye as a circle of the same size, with its
// centre of gravity where the point lies. The element is not ended: "<circle … r="4"".
std::string symbol(Symbol kind, Point at, double size) {
  constexpr double arm = 0.38;  // half the width of an arm of the cross
  switch (kind) {
    case Symbol::circle:
      break;
    case Symbol::square:
      return outline(at, 0.89 * size, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    case Symbol::triangle:
      return outline(at, 1.1 * size, {{0, -1.2}, {1, 0.6}, {-1, 0.6}});
    case Symbol::diamond:
      return outline(at, 1.25 * size, {{0, -1}, {1, 0}, {0, 1}, {-1, 0}});
    case Symbol::cross:
      return outline(at, 1.1 * size,
                     {{-arm, -1},
                      {arm, -1},
                      {arm, -arm},
                      {1, -arm},
                      {1, arm},
                      {arm, arm},
                      {arm, 1},
                      {-arm, 1},
                      {-arm, arm},
                      {-1, arm},
                      {-1, -arm},
                      {-arm, -arm}});
    case Symbol::wedge:
      return outline(at, 1.1 * size, {{0, 1.2}, {1, -0.6}, {-1, -0.6}});
    case Symbol::tick:
      return outline(at, size, {{-0.2, -1.6}, {0.2, -1.6}, {0.2, 1.6}, {-0.2, 1.6}});
  }
  return "<circle cx=\"" + svg::number(at.x) + "\" cy=\"" + svg::number(at.y) + "\" r=\"" +
         svg::number(size) + "\"";
}

const std::string no_fill = " fill=\"none\"";
constexpr double bar_share = 0.8;  // share of a category

// Tooltip of a mark; its lines stay lines.
std::string hint(const std::string& title) {
  std::string lines;
  for (std::size_t begin = 0; begin <= title.size();) {
    const std::size_t end = std::min(title.find('\n', begin), title.size());
    lines += (begin == 0 ? "" : "\n") + svg::escape(title.substr(begin, end - begin));
    begin = end + 1;
  }
  return "<title>" + lines + "</title>";
}

std::string draw(const ChartText& text) {
  const DrawnText& drawn = text.drawn;
  const Box& box = drawn.box;
  if (!text.turned && text.whole.empty()) return svg::text(drawn);
  std::string begun = "<text";
  if (text.turned) {
    // Turned about its anchor: what is its left when it lies flat is its bottom.
    const Box flat{-box.bottom, box.left, -box.top, box.right};
    const double x = (box.left + box.right) / 2 + 0.36 * drawn.size;
    begun +=
        attribute("transform", "translate(" + svg::number(x) + " " +
                                   svg::number(-svg::anchor(flat, drawn.align)) + ") rotate(-90)");
  } else {
    begun += attribute("x", svg::number(svg::anchor(box, drawn.align)));
    begun += attribute("y", svg::number((box.top + box.bottom) / 2 + 0.36 * drawn.size));
  }
  begun += attribute("font-size", svg::number(drawn.size)) + svg::anchor(drawn.align);
  if (drawn.weight == Weight::bold) begun += attribute("font-weight", "bold");
  const std::string title = text.whole.empty() ? "" : hint(text.whole);
  return begun + ">" + title + svg::escape(drawn.text) + "</text>\n";
}

std::string draw(const LaidLabel& label) {
  const std::string leader = label.has_leader
                                 ? svg::group(no_fill + attribute("stroke", "currentColor") +
                                                  attribute("stroke-width", "0.7"),
                                              svg::line(label.from, label.to))
                                 : "";
  return leader + draw(label.text);
}

// Closes an element that was begun.
std::string ended(const std::string& begun, const char* name, const std::string& title) {
  if (title.empty()) return begun + "/>\n";
  return begun + ">" + hint(title) + "</" + name + ">\n";
}

std::string rectangle(const Box& box) {
  return "<rect" + attribute("x", svg::number(box.left)) + attribute("y", svg::number(box.top)) +
         attribute("width", svg::number(box.right - box.left)) +
         attribute("height", svg::number(box.bottom - box.top));
}

std::string path(const std::string& commands) { return "<path" + attribute("d", commands); }

std::string line(Point from, Point to, const std::string& title) {
  return ended(path(svg::move_to(from) + svg::line_to(to)), "path", title);
}

// Draws those items that have a place.
template <typename Item, typename Draw>
std::string each(const std::vector<Item>& items, Draw draw) {
  std::string text;
  for (const Item& item : items) {
    if (can_be_drawn(item)) text += draw(item);
  }
  return text;
}

std::string dashes(Dash dash) {
  constexpr std::array<const char*, 3> arrays{"", "6 4", "2 3"};
  const char* array = arrays[static_cast<std::size_t>(dash)];
  return dash == Dash::solid ? "" : attribute("stroke-dasharray", array);
}

std::string stroke(const Style& style) {
  return attribute("stroke", "currentColor") + attribute("stroke-width", svg::number(style.line)) +
         dashes(style.dash);
}

std::string filled(const Style& style, bool outlined) {
  std::string text = attribute("fill", "currentColor");
  if (style.fill < 1) text += attribute("fill-opacity", svg::number(style.fill));
  return outlined ? text + stroke(style) : text;
}

// Style attributes of marks of this kind, and the name of their group.
struct Appearance {
  const char* name;
  std::string attributes;
};

Appearance appearance(const Layer& layer) {
  const Style& style = layer.style;
  struct Visitor {
    const Style& style;
    Appearance operator()(const Points&) const {
      return {"reeve-points", filled(style, style.fill < 1)};
    }
    Appearance operator()(const Bars&) const {
      return {"reeve-bars", filled(style, style.fill < 1)};
    }
    Appearance operator()(const Spans&) const { return {"reeve-spans", no_fill + stroke(style)}; }
    Appearance operator()(const Paths&) const {
      return {"reeve-paths", no_fill + stroke(style) + attribute("stroke-linejoin", "round")};
    }
    Appearance operator()(const PanelBands&) const { return {"reeve-bands", filled(style, false)}; }
    Appearance operator()(const Texts&) const { return {"reeve-texts", ""}; }
    Appearance operator()(const Ribbons&) const { return {"reeve-ribbons", filled(style, false)}; }
    Appearance operator()(const Rules&) const { return {"reeve-rules", no_fill + stroke(style)}; }
  };
  return std::visit(Visitor{style}, layer.marks);
}

std::string group(const Layer& layer, const std::string& content, bool in_legend) {
  const Appearance shown = appearance(layer);
  std::string attributes = attribute("class", (in_legend ? std::string("reeve-key") : shown.name) +
                                                  colour_class(layer.style.colour));
  if (!in_legend && !layer.name.empty()) {
    attributes += attribute("data-series", svg::escape(layer.name));
  }
  attributes += colour_attribute(layer.style.colour) + shown.attributes;
  if (layer.style.opacity < 1) attributes += attribute("opacity", svg::number(layer.style.opacity));
  return svg::group(attributes, content);
}

// Place of a slot of a category, in units of the axis.
double beside(double at, const Slot& slot) {
  const double slots = static_cast<double>(std::max<std::size_t>(slot.slots, 1));
  return at + bar_share * ((static_cast<double>(slot.slot) + 0.5) / slots - 0.5);
}

class Drawing {
 public:
  Drawing(const Layer& layer, const LaidPanel& panel) : style_(layer.style), panel_(panel) {}

  std::string operator()(const Points& points) const {
    const char* const name = style_.symbol == Symbol::circle ? "circle" : "path";
    return each(points.spots, [&](const Spot& spot) {
      return ended(symbol(style_.symbol, place(panel_, spot.x, spot.y), style_.size), name,
                   spot.title);
    });
  }

  std::string operator()(const Bars& bars) const {
    const auto slots = static_cast<double>(std::max<std::size_t>(bars.beside.slots, 1));
    return each(bars.bars, [&](const Spot& bar) {
      const double x = beside(bar.x, bars.beside);
      const Point one = place(panel_, x - bar_share / slots / 2, 0);
      const Point other = place(panel_, x + bar_share / slots / 2, bar.y);
      return ended(rectangle({one.x, std::min(one.y, other.y), other.x, std::max(one.y, other.y)}),
                   "rect", bar.title);
    });
  }

  std::string operator()(const Spans& spans) const {
    return each(spans.spans, [&](const Span& span) {
      const double at = beside(span.at, spans.beside);
      const bool across = spans.along == Along::x;
      return line(across ? place(panel_, span.low, at) : place(panel_, at, span.low),
                  across ? place(panel_, span.high, at) : place(panel_, at, span.high), span.title);
    });
  }

  std::string operator()(const Paths& paths) const {
    std::string text;
    for (const Polyline& polyline : paths.paths) {
      const std::string commands = through(polyline, paths.steps);
      if (!commands.empty()) text += ended(path(commands), "path", polyline.title);
    }
    return text;
  }

  std::string operator()(const Ribbons& ribbons) const {
    std::string text;
    for (const Ribbon& ribbon : ribbons.ribbons) {
      const std::string commands = around(ribbon);
      if (!commands.empty()) text += ended(path(commands), "path", ribbon.title);
    }
    return text;
  }

  std::string operator()(const PanelBands& bands) const {
    std::string text;
    for (const Span& band : bands.bands) {
      if (!can_be_drawn(band.low) || !can_be_drawn(band.high)) continue;
      Box box = panel_.frame;
      if (bands.on == Along::x) {
        box.left = place(panel_.x.scale, band.low);
        box.right = place(panel_.x.scale, band.high);
      } else {
        box.bottom = place(panel_.y.scale, band.low);
        box.top = place(panel_.y.scale, band.high);
      }
      text += ended(rectangle(box), "rect", band.title);
    }
    return text;
  }

  std::string operator()(const Texts& texts) const {
    return each(texts.texts, [&](const Spot& spot) {
      const Point centre = place(panel_, spot.x, spot.y);
      const ChartText shown{{{}, spot.label, small_text}, false, ""};
      return draw(at(shown, {centre.x, centre.y - line_of(small_text) / 2}, Align::middle));
    });
  }

  std::string operator()(const Rules& rules) const {
    return each(rules.rules, [&](const Level& rule) {
      Point from{panel_.frame.left, panel_.frame.top};
      Point to{panel_.frame.right, panel_.frame.bottom};
      if (rules.on == Along::x) {
        from.x = to.x = place(panel_.x.scale, rule.at);
      } else {
        from.y = to.y = place(panel_.y.scale, rule.at);
      }
      return line(from, to, rule.title);
    });
  }

 private:
  std::string through(const Polyline& polyline, bool steps) const {
    std::string commands;
    bool open = false;
    Point last;
    for (const Point& spot : polyline.through) {
      const bool shown = can_be_drawn(spot);
      if (shown) {
        const Point at = place(panel_, spot.x, spot.y);
        if (open && steps) commands += svg::line_to({at.x, last.y});
        commands += open ? svg::line_to(at) : svg::move_to(at);
        last = at;
      }
      open = shown;
    }
    return commands;
  }

  // There along what is high, back along what is low, once for each stretch without a gap.
  std::string around(const Ribbon& ribbon) const {
    std::string commands;
    std::string back;
    const auto close = [&] {
      if (!back.empty()) commands += back + "Z";
      back.clear();
    };
    for (const Span& span : ribbon.through) {
      if (!can_be_drawn(span)) {
        close();
        continue;
      }
      const Point high = place(panel_, span.at, span.high);
      commands += back.empty() ? svg::move_to(high) : svg::line_to(high);
      back.insert(0, svg::line_to(place(panel_, span.at, span.low)));
    }
    close();
    return commands;
  }

  const Style& style_;
  const LaidPanel& panel_;
};

std::string legend_symbol(const Layer& layer, const Box& room) {
  const Point centre{(room.left + room.right) / 2, (room.top + room.bottom) / 2};
  if (std::holds_alternative<Points>(layer.marks)) {
    const double size = std::clamp(layer.style.size, 3.0, 6.0);
    return symbol(layer.style.symbol, centre, size) + "/>\n";
  }
  if (std::holds_alternative<Bars>(layer.marks) ||
      std::holds_alternative<PanelBands>(layer.marks) ||
      std::holds_alternative<Ribbons>(layer.marks)) {
    return rectangle({centre.x - 7, centre.y - 6, centre.x + 7, centre.y + 6}) + "/>\n";
  }
  return svg::line({room.left, centre.y}, {room.right, centre.y});
}

// A group with one element for each mark.
std::string draw(const Layer& layer, const LaidPanel& panel) {
  return group(layer, std::visit(Drawing(layer, panel), layer.marks), false);
}

std::string draw(const LegendEntry& entry) {
  std::string symbols;
  for (const Layer* layer : entry.layers) {
    symbols += group(*layer, legend_symbol(*layer, entry.symbol), true);
  }
  return symbols + draw(entry.text);
}

// The grid, and short lines outside the frame, at the ticks of the axes that show any.
struct AxisLines {
  std::string grid;
  std::string ticks;
};

AxisLines axis_lines(const LaidPanel& laid) {
  constexpr double length = 4;
  const auto [left, top, right, bottom] = laid.frame;
  AxisLines lines;
  for (const Tick& tick : laid.x.ticks) {
    if (laid.panel->x.hidden) continue;
    const Point at{tick.at, bottom};
    if (laid.panel->x.grid) lines.grid += svg::move_to({tick.at, top}) + svg::line_to(at);
    lines.ticks += svg::move_to(at) + svg::line_to({tick.at, bottom + length});
  }
  for (const Tick& tick : laid.y.ticks) {
    if (laid.panel->y.hidden) continue;
    const Point at{left, tick.at};
    if (laid.panel->y.grid) lines.grid += svg::move_to(at) + svg::line_to({right, tick.at});
    if (!laid.numbers_at_y) continue;
    lines.ticks += svg::move_to({left - length, tick.at}) + svg::line_to(at);
  }
  return lines;
}

std::string lines_path(const std::string& lines, const char* attributes) {
  return lines.empty() ? "" : svg::path(lines, attributes);
}

std::string texts(const std::vector<ChartText>& texts) {
  std::string all;
  for (const ChartText& text : texts) all += draw(text);
  return all;
}

std::string panel(const LaidPanel& laid, const std::vector<LaidLabel>& labels) {
  const AxisLines lines = axis_lines(laid);
  std::string content =
      lines_path(lines.grid, " class=\"reeve-grid\" fill=\"none\" stroke=\"#dddddd\"");
  content += svg::rectangle(laid.frame, 0, " fill=\"none\" stroke=\"#a0a0a0\"");
  for (const Layer& layer : laid.panel->layers) content += draw(layer, laid);
  std::string names;
  for (const LaidLabel& label : labels) names += draw(label);
  content += svg::group(" class=\"reeve-labels\"", names);
  content +=
      svg::group(" class=\"reeve-axes\"",
                 lines_path(lines.ticks, " fill=\"none\" stroke=\"#808080\"") + texts(laid.texts));
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

Colour series_colour(std::size_t i) { return static_cast<Colour>(i % 7); }

Symbol series_symbol(std::size_t i) { return static_cast<Symbol>(i % 6); }

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
