#include "drawing/chart/chart_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "drawing/chart/chart_colours.hpp"
#include "drawing/chart/chart_symbols.hpp"
#include "drawing/svg.hpp"

namespace reeve::drawing::chart {
namespace {

constexpr double bar_share = 0.8;  // of a category

using svg::attribute;

// What a reader sees who points there; its lines stay lines.
std::string hint(const std::string& title) {
  std::string lines;
  for (std::size_t begin = 0; begin <= title.size();) {
    const std::size_t end = std::min(title.find('\n', begin), title.size());
    lines += (begin == 0 ? "" : "\n") + svg::escape(title.substr(begin, end - begin));
    begin = end + 1;
  }
  return "<title>" + lines + "</title>";
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

const std::string no_fill = " fill=\"none\"";

// How the marks of this kind show the style, and what their group is called.
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
    Appearance operator()(const Bands&) const { return {"reeve-bands", filled(style, false)}; }
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

// Where the slot-th of the slots of a category lies, in units of the axis.
double beside(double at, const Slot& slot) {
  const double slots = static_cast<double>(std::max<std::size_t>(slot.slots, 1));
  return at + bar_share * ((static_cast<double>(slot.slot) + 0.5) / slots - 0.5);
}

class Drawing {
 public:
  Drawing(const Layer& layer, const LaidPanel& panel) : style_(layer.style), panel_(panel) {}

  std::string operator()(const Points& points) const {
    std::string text;
    for (const Spot& spot : points.spots) {
      if (!can_be_drawn(spot.x) || !can_be_drawn(spot.y)) continue;
      const std::string begun = symbol(style_.symbol, place(panel_, spot.x, spot.y), style_.size);
      text += ended(begun, style_.symbol == Symbol::circle ? "circle" : "path", spot.title);
    }
    return text;
  }

  std::string operator()(const Bars& bars) const {
    std::string text;
    const auto slots = static_cast<double>(std::max<std::size_t>(bars.beside.slots, 1));
    for (const Spot& bar : bars.bars) {
      if (!can_be_drawn(bar.x) || !can_be_drawn(bar.y)) continue;
      const double x = beside(bar.x, bars.beside);
      const Point one = place(panel_, x - bar_share / slots / 2, 0);
      const Point other = place(panel_, x + bar_share / slots / 2, bar.y);
      text += ended(rectangle({one.x, std::min(one.y, other.y), other.x, std::max(one.y, other.y)}),
                    "rect", bar.title);
    }
    return text;
  }

  std::string operator()(const Spans& spans) const {
    std::string text;
    for (const Span& span : spans.spans) {
      if (!can_be_drawn(span.at) || !can_be_drawn(span.low) || !can_be_drawn(span.high)) continue;
      const double at = beside(span.at, spans.beside);
      const bool across = spans.along == Along::x;
      const Point from = across ? place(panel_, span.low, at) : place(panel_, at, span.low);
      const Point to = across ? place(panel_, span.high, at) : place(panel_, at, span.high);
      text += ended(path(svg::move_to(from) + svg::line_to(to)), "path", span.title);
    }
    return text;
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

  std::string operator()(const Bands& bands) const {
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
    std::string text;
    for (const Spot& spot : texts.texts) {
      if (!can_be_drawn(spot.x) || !can_be_drawn(spot.y)) continue;
      const Point centre = place(panel_, spot.x, spot.y);
      const ChartText shown{{{}, spot.label, small_text}, false, ""};
      text += draw(at(shown, {centre.x, centre.y - line_of(small_text) / 2}, Align::middle));
    }
    return text;
  }

  std::string operator()(const Rules& rules) const {
    std::string text;
    for (const Level& rule : rules.rules) {
      if (!can_be_drawn(rule.at)) continue;
      Point from{panel_.frame.left, panel_.frame.top};
      Point to{panel_.frame.right, panel_.frame.bottom};
      if (rules.on == Along::x) {
        from.x = to.x = place(panel_.x.scale, rule.at);
      } else {
        from.y = to.y = place(panel_.y.scale, rule.at);
      }
      text += ended(path(svg::move_to(from) + svg::line_to(to)), "path", rule.title);
    }
    return text;
  }

 private:
  std::string through(const Polyline& polyline, bool steps) const {
    std::string commands;
    bool open = false;
    Point last;
    for (const Point& spot : polyline.through) {
      const bool shown = can_be_drawn(spot.x) && can_be_drawn(spot.y);
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
      if (!can_be_drawn(span.at) || !can_be_drawn(span.low) || !can_be_drawn(span.high)) {
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
  if (std::holds_alternative<Bars>(layer.marks) || std::holds_alternative<Bands>(layer.marks) ||
      std::holds_alternative<Ribbons>(layer.marks)) {
    return rectangle({centre.x - 7, centre.y - 6, centre.x + 7, centre.y + 6}) + "/>\n";
  }
  return svg::line({room.left, centre.y}, {room.right, centre.y});
}

}  // namespace

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

}  // namespace reeve::drawing::chart
