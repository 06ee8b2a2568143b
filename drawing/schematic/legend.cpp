// Legend of a schematic's symbols: the texts, their places and the drawing.
#include <array>

#include "core/performance.hpp"
#include "drawing/schematic/schematic_symbols.hpp"
#include "drawing/svg.hpp"

namespace reeve::drawing {
namespace {

using namespace measures;

struct SymbolMeaning {
  LegendSymbol symbol;
  const char* text;
  bool DrawnParts::*part;  // shown where there are such; none: always
  bool of_tension = false;
};

constexpr double legend_size = 12;
constexpr std::array<SymbolMeaning, 11> legend_entries{
    {{LegendSymbol::tube, "tube", &DrawnParts::tubes},
     {LegendSymbol::bearing, "bearing", &DrawnParts::bearings},
     {LegendSymbol::sheath, "sheath", &DrawnParts::sheaths},
     {LegendSymbol::fixed, "fixed (F)", &DrawnParts::fixed},
     {LegendSymbol::tied, "tied (M)", &DrawnParts::tied},
     {LegendSymbol::anchored, "tied (1x)", &DrawnParts::anchors},
     {LegendSymbol::extensor, "back (1e)", &DrawnParts::extensors},
     {LegendSymbol::block, "block (Y)", &DrawnParts::blocks},
     {LegendSymbol::bar, "bar (W)", &DrawnParts::bars},
     {LegendSymbol::slides, "slides", nullptr, true},
     {LegendSymbol::slack, "slack", &DrawnParts::slack, true}}};

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

std::string legend_symbol(const LegendItem& item) {
  const Point centre{(item.box.left + item.box.right) / 2, (item.box.top + item.box.bottom) / 2};
  const DrawnContact small{ContactKind::tube, ContactPlace::tip, {centre.x, centre.y + 3}, 7, -1};
  DrawnContact sheath = small;
  sheath.centre = centre;
  sheath.length = 18;
  switch (item.symbol) {
    case LegendSymbol::tube:
      return symbols::tube(small, 3);
    case LegendSymbol::bearing:
      return symbols::wheel(centre, 8);
    case LegendSymbol::sheath:
      return symbols::sheath(sheath, 4.5);
    case LegendSymbol::fixed:
      return symbols::fixation({EndHold::fixed, {centre.x, centre.y - 3}, 1}, 18, 10);
    case LegendSymbol::tied:
      return symbols::knot(centre, 10);
    case LegendSymbol::anchored:
      return symbols::anchor(centre, 5);
    case LegendSymbol::extensor:
      return symbols::extensor(centre, 5);
    case LegendSymbol::block: {
      DrawnBlock block;
      block.axles = {{centre.x, centre.y - 3}};
      block.sheave = 6;
      block.tails = {{centre.x, centre.y + 8}};
      block.beam = centre.y + 7;
      return symbols::shell(block) + symbols::wheel(block.axles.front(), 6.5);
    }
    case LegendSymbol::bar: {
      DrawnBlock bar;
      bar.is_bar = true;
      bar.eyes = {{centre.x - 7, centre.y}, {centre.x + 7, centre.y}};
      bar.tails = {centre};
      bar.beam = centre.y;
      return symbols::shell(bar) + symbols::eyes(bar);
    }
    case LegendSymbol::slides:
      return symbols::straight_arrow({item.box.left + 2, centre.y}, {item.box.right - 2, centre.y});
    case LegendSymbol::slack:
      return svg::path(
          svg::move_to({item.box.left, centre.y}) + svg::line_to({item.box.right, centre.y}),
          " stroke-dasharray=\"5 4\"");
  }
  return "";
}

}  // namespace

DrawnParts& DrawnParts::operator|=(const DrawnParts& other) {
  for (const SymbolMeaning& entry : legend_entries) {
    if (entry.part != nullptr) this->*entry.part = this->*entry.part || other.*entry.part;
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
  const auto extensors = std::ranges::count_if(
      network.segments, [](const Segment& strand) { return strand.extensor; });
  parts.anchors = count.anchors > extensors;
  parts.extensors = extensors > 0;
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
    if (entry.part != nullptr && !(parts.*entry.part)) continue;
    if (entry.of_tension && !with_tension) continue;
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

std::string symbols::legend(const Legend& legend) {
  return svg::group(strokes, svg::each(legend.items, legend_symbol)) +
         svg::each(legend.texts, svg::text);
}

}  // namespace reeve::drawing
