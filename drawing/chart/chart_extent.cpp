#include "drawing/chart/chart_extent.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::drawing::chart {
namespace {

bool both_drawn(double x, double y) { return can_be_drawn(x) && can_be_drawn(y); }

void add_spots(const std::vector<Spot>& spots, Along along, Extent& extent) {
  for (const Spot& spot : spots) {
    if (both_drawn(spot.x, spot.y)) extent.add(along == Along::x ? spot.x : spot.y);
  }
}

struct Adding {
  Along along;
  Extent& extent;

  void operator()(const Points& points) const { add_spots(points.spots, along, extent); }
  void operator()(const Texts& texts) const { add_spots(texts.texts, along, extent); }
  void operator()(const Bars& bars) const {
    add_spots(bars.bars, along, extent);
    if (along == Along::y) extent.add(0);
  }
  void operator()(const Spans& spans) const {
    for (const Span& span : spans.spans) {
      if (!both_drawn(span.low, span.high) || !can_be_drawn(span.at)) continue;
      if (spans.along == along) {
        extent.add(span.low);
        extent.add(span.high);
      } else {
        extent.add(span.at);
      }
    }
  }
  void operator()(const Ribbons& ribbons) const {
    for (const Ribbon& ribbon : ribbons.ribbons) {
      for (const Span& span : ribbon.through) {
        if (!both_drawn(span.low, span.high) || !can_be_drawn(span.at)) continue;
        if (along == Along::x) {
          extent.add(span.at);
        } else {
          extent.add(span.low);
          extent.add(span.high);
        }
      }
    }
  }
  void operator()(const Paths& paths) const {
    for (const Polyline& path : paths.paths) {
      for (const Point& at : path.through) {
        if (both_drawn(at.x, at.y)) extent.add(along == Along::x ? at.x : at.y);
      }
    }
  }
  void operator()(const Bands& bands) const {
    if (bands.on != along) return;
    for (const Span& band : bands.bands) {
      extent.add(band.low);
      extent.add(band.high);
    }
  }
  void operator()(const Rules& rules) const {
    if (rules.on != along) return;
    for (const Level& rule : rules.rules) extent.add(rule.at);
  }
};

}  // namespace

Extent extent(const Panel& panel, Along along) {
  const Axis& of = panel.one_scale ? panel.x : axis(panel, along);
  Extent extent;
  if (!of.categories.empty()) {
    extent.add(-0.5);
    extent.add(static_cast<double>(of.categories.size()) - 0.5);
    return extent;
  }
  for (const double value : of.reaches) extent.add(value);
  for (const Layer& layer : panel.layers) {
    std::visit(Adding{along, extent}, layer.marks);
    const Along other = along == Along::x ? Along::y : Along::x;
    if (panel.one_scale) std::visit(Adding{other, extent}, layer.marks);
  }
  return extent;
}

Extent widened(const Axis& axis, const Extent& marks) {
  Extent extent = marks;
  if (extent.empty()) {
    extent.low = axis.least.value_or(std::min(0.0, axis.greatest.value_or(1) - 1));
    extent.high = axis.greatest.value_or(extent.low + 1);
  }
  if (extent.high > extent.low) return extent;
  const double value = extent.low;
  const double by = value == 0 || axis.whole ? 1 : 0.1 * std::abs(value);
  extent.low = std::max(value - by, axis.least.value_or(value - by));
  extent.high = std::min(value + by, axis.greatest.value_or(value + by));
  // Where nothing is possible beside the value, or the limits are the wrong way round.
  if (extent.high <= extent.low) return {value - by, value + by};
  return extent;
}

Inset inset(const Panel& panel, Along along, double length) {
  double half = 0;
  bool has_bars = false;
  for (const Layer& layer : panel.layers) {
    has_bars = has_bars || std::holds_alternative<Bars>(layer.marks);
    if (!std::holds_alternative<Points>(layer.marks)) continue;
    const double widest = layer.style.symbol == Symbol::tick ? 1.6 : 1.35;
    half = std::max(half, widest * layer.style.size + layer.style.line + 1);
  }
  const auto categories = static_cast<double>(axis(panel, along).categories.size());
  if (categories == 1) return {};
  if (categories > 1) {
    // With i the inset, half a category is (length - 2 i) / 2 / categories: with i it must be half.
    const double room = (half - length / 2 / categories) / (1 - 1 / categories);
    return {std::max(0.0, room), std::max(0.0, room)};
  }
  if (has_bars && along == Along::y) return {0, std::max(half, 4.0)};
  return {half, half};
}

const Axis& axis(const Panel& panel, Along along) { return along == Along::x ? panel.x : panel.y; }

}  // namespace reeve::drawing::chart
