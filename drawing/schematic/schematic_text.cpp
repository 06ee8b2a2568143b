#include "drawing/schematic/schematic_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/performance.hpp"
#include "drawing/schematic/fittings.hpp"
#include "drawing/schematic/schematic_measures.hpp"

namespace reeve::drawing {

using namespace measures;

namespace {

double add_lines(const std::string& text, double top, DrawnText style, SchematicLayout& layout) {
  const double width = layout.width - 2 * margin;
  const bool bold = style.weight == Weight::bold;
  for (const std::string& piece : wrap(text, style.size, bold, width)) {
    style.text = piece;
    style.box = {margin, top, margin + std::min(width, text_width(piece, style.size, bold)),
                 top + style.size + 4};
    layout.texts.push_back(style);
    top = style.box.bottom;
  }
  return top;
}

struct SymbolMeaning {
  LegendSymbol symbol;
  const char* text;
};

constexpr double legend_size = 12;
constexpr std::array<SymbolMeaning, 10> legend_entries{{{LegendSymbol::tube, "tube"},
                                                        {LegendSymbol::bearing, "bearing"},
                                                        {LegendSymbol::sheath, "sheath"},
                                                        {LegendSymbol::fixed, "fixed (F)"},
                                                        {LegendSymbol::tied, "tied (M)"},
                                                        {LegendSymbol::anchored, "tied (1x)"},
                                                        {LegendSymbol::block, "block (Y)"},
                                                        {LegendSymbol::bar, "bar (W)"},
                                                        {LegendSymbol::slides, "slides"},
                                                        {LegendSymbol::slack, "slack"}}};

bool is_shown(LegendSymbol symbol, bool with_tension, const DrawnParts& parts) {
  switch (symbol) {
    case LegendSymbol::slides:
      return with_tension;
    case LegendSymbol::slack:
      return with_tension && parts.slack;
    case LegendSymbol::anchored:
      return parts.anchors;
    case LegendSymbol::block:
      return parts.blocks;
    case LegendSymbol::bar:
      return parts.bars;
    case LegendSymbol::tube:
      return parts.tubes;
    case LegendSymbol::bearing:
      return parts.bearings;
    case LegendSymbol::sheath:
      return parts.sheaths;
    case LegendSymbol::fixed:
      return parts.fixed;
    case LegendSymbol::tied:
      return parts.tied;
  }
  return true;
}

DrawnText motor_text(const SchematicLayout& layout) {
  const double top = (layout.motor.top + layout.motor.bottom - line_height) / 2;
  const double width = text_width("motor 1.00", small_size, false);
  constexpr double aside = 5;
  DrawnText text{{}, "", small_size, Weight::normal, Align::start};
  const double right = layout.motor.right + aside;
  text.box = {right, top, right + width, top + line_height};
  if (text.box.right > layout.width - margin / 2) {
    const double left = layout.motor.left - aside;
    text.box = {left - width, top, left, top + line_height};
    text.align = Align::end;
  }
  return text;
}

}  // namespace

double add_heading(const SchematicFrame& frame, SchematicLayout& layout) {
  const double title = add_lines(frame.title, 10, {{}, "", 16, Weight::bold}, layout);
  const double subtitle =
      add_lines(frame.subtitle, title, {{}, "", small_size, Weight::normal}, layout);
  return subtitle + 6;
}

void add_finger_name(int number, const DrawnFinger& finger, SchematicLayout& layout) {
  const double middle = (finger.outline.left + finger.outline.right) / 2;
  double bottom = finger.held ? finger.object.top - 1 : finger.outline.top - 3;
  const auto add = [&](const std::string& text, Weight weight) {
    const double half = text_width(text, small_size, weight == Weight::bold) / 2;
    layout.texts.push_back({{middle - half, bottom - line_height, middle + half, bottom},
                            text,
                            small_size,
                            weight,
                            Align::middle});
    bottom -= line_height;
  };
  if (finger.held) add("held", Weight::bold);
  add(fmt::format("finger {}", number), Weight::normal);
}

void place_label(double x, double top, bool to_the_right, DrawnSegment& drawn) {
  const double left = to_the_right ? x + label_gap : x - label_gap - label_width;
  drawn.label = {left, top, left + label_width, top + label_height};
  drawn.align = to_the_right ? Align::start : Align::end;
}

void place_carriage(double left, double right, double top, double bottom, SchematicLayout& layout) {
  constexpr double overhang = 22;
  constexpr double arrow = 34;
  layout.carriage = {left - overhang, top, right + overhang, bottom};
  const double x = (left + right) / 2;
  layout.motor = {x - 6, bottom + 2, x + 6, bottom + 2 + arrow};
  layout.motor_text = motor_text(layout);
}

namespace {

void add_note(const Box& room, Legend& legend) {
  const std::string note = "line width and number: tension at motor tension 1";
  for (const std::string& piece : wrap(note, legend_size, false, room.right - room.left)) {
    const double right = room.left + text_width(piece, legend_size, false);
    const double bottom = legend.bottom + legend_size + 4;
    legend.texts.push_back(
        {{room.left, legend.bottom, right, bottom}, piece, legend_size, Weight::normal});
    legend.bottom = bottom;
  }
}

}  // namespace

DrawnParts& DrawnParts::operator|=(const DrawnParts& other) {
  for (const auto part : {&DrawnParts::tubes, &DrawnParts::bearings, &DrawnParts::sheaths,
                          &DrawnParts::fixed, &DrawnParts::tied, &DrawnParts::anchors,
                          &DrawnParts::blocks, &DrawnParts::bars, &DrawnParts::slack}) {
    this->*part = this->*part || other.*part;
  }
  return *this;
}

DrawnParts drawn_parts(const Network& network) {
  const PartCount count = core::parts(network);
  DrawnParts parts;
  parts.tubes = count.tubes > 0;
  parts.bearings = count.pulleys > 0;
  parts.sheaths = count.sheaths > 0;
  parts.fixed = count.fixed_ends > 0;
  parts.tied = count.sheaths > 2 * count.movable_pulleys;
  parts.anchors = count.anchors > 0;
  parts.blocks = count.blocks > 0;
  parts.bars = count.bars > 0;
  return parts;
}

Legend legend(const Box& room, bool with_tension, const DrawnParts& parts) {
  constexpr double symbol = 22;
  constexpr double high = 22;
  constexpr double cell = 86;
  Legend legend;
  double x = room.left;
  double y = room.top;
  for (const SymbolMeaning& entry : legend_entries) {
    if (!is_shown(entry.symbol, with_tension, parts)) continue;
    if (x + cell > room.right + 1) {
      x = room.left;
      y += high;
    }
    legend.items.push_back({entry.symbol, {x, y, x + symbol, y + high}});
    const double left = x + symbol + 4;
    const double right = left + text_width(entry.text, legend_size, false);
    legend.texts.push_back(
        {{left, y + 3, right, y + high - 3}, entry.text, legend_size, Weight::normal});
    x += cell;
  }
  legend.bottom = y + high + 2;
  if (with_tension) add_note(room, legend);
  return legend;
}

}  // namespace reeve::drawing
