#include <algorithm>
#include <cmath>

#include "drawing/chart/chart_layout.hpp"

namespace reeve::drawing::chart {
namespace {

class Reaching {
 public:
  Reaching(Along along, Extent& extent) : along_(along), extent_(extent) {}

  void operator()(const Points& points) const { add(points.spots); }
  void operator()(const Texts& texts) const { add(texts.texts); }
  void operator()(const Bars& bars) const {
    add(bars.bars);
    if (along_ == Along::y) extent_.add(0);
  }
  void operator()(const Spans& spans) const {
    for (const Span& span : spans.spans) add(span, spans.along);
  }
  void operator()(const Ribbons& ribbons) const {
    for (const Ribbon& ribbon : ribbons.ribbons) {
      for (const Span& span : ribbon.through) add(span, Along::y);
    }
  }
  void operator()(const Paths& paths) const {
    for (const Polyline& path : paths.paths) add(path.through);
  }
  void operator()(const PanelBands& bands) const {
    if (bands.on != along_) return;
    for (const Span& band : bands.bands) add_ends(band);
  }
  void operator()(const Rules& rules) const {
    if (rules.on != along_) return;
    for (const Level& rule : rules.rules) extent_.add(rule.at);
  }

 private:
  template <typename Place>
  void add(const std::vector<Place>& places) const {
    for (const Place& at : places) {
      if (can_be_drawn(at)) extent_.add(along_ == Along::x ? at.x : at.y);
    }
  }

  void add(const Span& span, Along lengthwise) const {
    if (!can_be_drawn(span)) return;
    if (along_ == lengthwise) {
      add_ends(span);
    } else {
      extent_.add(span.at);
    }
  }

  void add_ends(const Span& span) const {
    extent_.add(span.low);
    extent_.add(span.high);
  }

  Along along_;
  Extent& extent_;
};

constexpr double tick_length = 5;
constexpr double beside_tick = tick_length + 3;  // distance from the frame to a tick's text
constexpr double before_title = 5;
constexpr double widest_category = 230;   // beside the y axis
constexpr double longest_category = 150;  // turned, below the x axis
constexpr double beyond_frame = 14;       // a title may be so much wider than the frame
constexpr std::size_t most_lines = 3;

double lowest(const std::vector<ChartText>& texts, double least) {
  for (const ChartText& text : texts) least = std::max(least, text.drawn.box.bottom);
  return least;
}

void add_lines(const std::vector<ChartText>& lines, Point top, Align align,
               std::vector<ChartText>& texts) {
  for (const ChartText& line : lines) {
    texts.push_back(at(line, top, align));
    top.y += line_of(line.drawn.size);
  }
}

std::vector<ChartText> tick_lines(const Tick& tick, double width, std::size_t most) {
  return broken(tick.text, tick_size, Weight::normal, width, most);
}

// True if each category has room for its text below its place.
bool lie_flat(const std::vector<Tick>& ticks, double width) {
  return std::ranges::all_of(ticks, [&](const Tick& tick) {
    const std::vector<ChartText> lines = tick_lines(tick, width, most_lines);
    return std::ranges::all_of(lines, [](const ChartText& line) { return line.whole.empty(); });
  });
}

void add_flat(const LaidPanel& laid, double width, std::vector<ChartText>& texts) {
  for (const Tick& tick : laid.x.ticks) {
    add_lines(tick_lines(tick, width, most_lines), {tick.at, laid.frame.bottom + beside_tick},
              Align::middle, texts);
  }
}

// Below each other if they are many: as many as have room.
void add_turned(const LaidPanel& laid, double step, std::vector<ChartText>& texts) {
  const double line = line_of(tick_size);
  const auto every = static_cast<std::size_t>(std::max(1.0, std::ceil(line / step)));
  for (std::size_t i = 0; i < laid.x.ticks.size(); i += every) {
    const Tick& tick = laid.x.ticks[i];
    texts.push_back(turned_at(cut(tick.text, tick_size, Weight::normal, longest_category),
                              {tick.at - line / 2, laid.frame.bottom + beside_tick}, Align::end));
  }
}

// Distance from one category to the next; all the room for a single one.
double step_of(const std::vector<Tick>& ticks, double length) {
  return ticks.size() < 2 ? length : std::abs(ticks[1].at - ticks[0].at);
}

void add_x_ticks(const LaidPanel& laid, std::vector<ChartText>& texts) {
  if (laid.panel->x.categories.empty()) {
    for (const Tick& tick : laid.x.ticks) {
      if (tick.text.empty()) continue;
      texts.push_back(at({{{}, tick.text, tick_size}, false, ""},
                         {tick.at, laid.frame.bottom + beside_tick}, Align::middle));
    }
    return;
  }
  const double step = step_of(laid.x.ticks, laid.frame.right - laid.frame.left);
  if (lie_flat(laid.x.ticks, step - 1)) {
    add_flat(laid, step - 1, texts);
  } else {
    add_turned(laid, step, texts);
  }
}

void add_y_ticks(const LaidPanel& laid, std::vector<ChartText>& texts) {
  const double step = step_of(laid.y.ticks, laid.frame.bottom - laid.frame.top);
  const double line = line_of(tick_size);
  const bool categories = !laid.panel->y.categories.empty();
  const auto lines =
      static_cast<std::size_t>(std::clamp(step / line, 1.0, static_cast<double>(most_lines)));
  const auto every =
      static_cast<std::size_t>(categories ? std::max(1.0, std::ceil(line / step)) : 1);
  for (std::size_t i = 0; i < laid.y.ticks.size(); i += every) {
    const Tick& tick = laid.y.ticks[i];
    if (tick.text.empty()) continue;
    const std::vector<ChartText> parts = tick_lines(tick, widest_category, lines);
    const double top = tick.at - static_cast<double>(parts.size()) * line / 2;
    add_lines(parts, {laid.frame.left - beside_tick, top}, Align::end, texts);
  }
}

void add_x_title(const LaidPanel& laid, std::vector<ChartText>& texts) {
  const Axis& axis = laid.panel->x;
  if (axis.title.empty() || axis.hidden) return;
  const double width = laid.frame.right - laid.frame.left;
  const double top = lowest(texts, laid.frame.bottom) + before_title;
  add_lines(broken(axis.title, title_text, Weight::normal, width, most_lines),
            {(laid.frame.left + laid.frame.right) / 2, top}, Align::middle, texts);
}

void add_y_title(const LaidPanel& laid, std::vector<ChartText>& texts) {
  const Axis& axis = laid.panel->y;
  if (axis.title.empty() || axis.hidden) return;
  double left = laid.frame.left;
  for (const ChartText& text : texts) left = std::min(left, text.drawn.box.left);
  const std::vector<ChartText> lines = broken(axis.title, title_text, Weight::normal,
                                              laid.frame.bottom - laid.frame.top, most_lines);
  const double line = line_of(title_text);
  left -= before_title + line * static_cast<double>(lines.size());
  for (const ChartText& text : lines) {
    texts.push_back(
        turned_at(text, {left, (laid.frame.top + laid.frame.bottom) / 2}, Align::middle));
    left += line;
  }
}

void add_title(const LaidPanel& laid, std::vector<ChartText>& texts) {
  if (laid.panel->title.empty()) return;
  const double width = laid.frame.right - laid.frame.left + beyond_frame;
  const std::vector<ChartText> lines =
      broken(laid.panel->title, title_text, Weight::bold, width, 2);
  const double height = line_of(title_text) * static_cast<double>(lines.size());
  add_lines(lines, {laid.frame.left, laid.frame.top - before_title - height}, Align::start, texts);
}

Inset inset(const Panel& panel, Along along, double length) {
  double half = 0;
  bool has_bars = false;
  for (const Layer& layer : panel.layers) {
    has_bars = has_bars || std::holds_alternative<Bars>(layer.marks);
    if (!std::holds_alternative<Points>(layer.marks)) continue;
    const double reach = layer.style.symbol == Symbol::tick ? 1.6 : 1.35;
    half = std::max(half, reach * layer.style.size + layer.style.line + 1);
  }
  const auto categories = static_cast<double>(axis(panel, along).categories.size());
  if (categories == 1) return {};
  if (categories > 1) {
    // Solves half = (length - 2 i) / 2 / categories + i for the inset i: half a category and the
    // inset.
    const double room = (half - length / 2 / categories) / (1 - 1 / categories);
    return {std::max(0.0, room), std::max(0.0, room)};
  }
  if (has_bars && along == Along::y) return {0, std::max(half, 4.0)};
  return {half, half};
}

LaidAxis lay_axis(const Panel& panel, Along along, const Extent& extent, Stretch stretch) {
  const Axis& of = axis(panel, along);
  stretch.inset = inset(panel, along, std::abs(stretch.to - stretch.from));
  if (!of.categories.empty()) {
    // Categories are read from the top down.
    if (along == Along::y) std::swap(stretch.from, stretch.to);
    return lay_categories(of, stretch);
  }
  return lay_numbers(of, extent, stretch, along);
}

// The axis in another direction.
LaidAxis turned(LaidAxis axis, const Scale& direction) {
  axis.scale.from = direction.from;
  axis.scale.to = direction.to;
  for (Tick& tick : axis.ticks) tick.at = place(axis.scale, tick.value);
  return axis;
}

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
    std::visit(Reaching(along, extent), layer.marks);
    const Along other = along == Along::x ? Along::y : Along::x;
    if (panel.one_scale) std::visit(Reaching(other, extent), layer.marks);
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
  // The value alone is possible, or the limits are the wrong way round.
  if (extent.high <= extent.low) return {value - by, value + by};
  return extent;
}

const Axis& axis(const Panel& panel, Along along) { return along == Along::x ? panel.x : panel.y; }

LaidPanel lay_panel(const Panel& panel, const PanelFrame& frame) {
  LaidPanel laid{&panel, {0, 0, frame.width, frame.height}, {}, {}, frame.numbers_at_y, {}};
  laid.x = lay_axis(panel, Along::x, frame.x, {0, frame.width, {}});
  laid.y = lay_axis(panel, Along::y, frame.y, {frame.height, 0, {}});
  if (panel.one_scale) laid.y = turned(laid.x, laid.y.scale);
  std::vector<ChartText> below;
  std::vector<ChartText> beside;
  if (!panel.x.hidden) add_x_ticks(laid, below);
  add_x_title(laid, below);
  if (!panel.y.hidden && frame.numbers_at_y) add_y_ticks(laid, beside);
  if (frame.numbers_at_y) add_y_title(laid, beside);
  add_title(laid, laid.texts);
  laid.texts.insert(laid.texts.end(), below.begin(), below.end());
  laid.texts.insert(laid.texts.end(), beside.begin(), beside.end());
  return laid;
}

void shift(LaidPanel& panel, double dx, double dy) {
  Box& frame = panel.frame;
  frame = {frame.left + dx, frame.top + dy, frame.right + dx, frame.bottom + dy};
  const auto move = [](LaidAxis& axis, double by) {
    axis.scale.from += by;
    axis.scale.to += by;
    for (Tick& tick : axis.ticks) tick.at += by;
  };
  move(panel.x, dx);
  move(panel.y, dy);
  for (ChartText& text : panel.texts) shift(text, dx, dy);
}

Box bounds(const LaidPanel& panel) {
  Box box = panel.frame;
  for (const ChartText& text : panel.texts) box = around(box, text.drawn.box);
  return box;
}

}  // namespace reeve::drawing::chart
