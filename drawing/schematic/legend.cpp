// What the symbols of a schematic mean: the texts and their places.
#include <array>

#include "core/performance.hpp"
#include "drawing/schematic/schematic_layout.hpp"

namespace reeve::drawing {
namespace {

using namespace measures;

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
