#include "drawing/chart/chart_text.hpp"

#include <algorithm>
#include <array>

namespace reeve::drawing::chart {
namespace {

double width_of(const ChartText& text) {
  const DrawnText& drawn = text.drawn;
  return measures::text_width(drawn.text, drawn.size, drawn.weight == Weight::bold);
}

// Off the last code point.
void shorten(std::string& text) {
  while (!text.empty() && (text.back() & '\xC0') == '\x80') text.pop_back();
  if (!text.empty()) text.pop_back();
}

// Begin of a stretch of this length that is aligned to `at`.
double begin(double at, double length, Align align) {
  if (align == Align::middle) return at - length / 2;
  return align == Align::start ? at : at - length;
}

constexpr double gap = 3;  // between a mark and its text, and between two texts
constexpr std::array<double, 5> rings{0, 12, 26, 44, 66};

bool overlap(const Box& a, const Box& b, double apart) {
  return a.left < b.right + apart && b.left < a.right + apart && a.top < b.bottom + apart &&
         b.top < a.bottom + apart;
}

bool within(const Box& box, const Box& frame) {
  return box.left >= frame.left && box.right <= frame.right && box.top >= frame.top &&
         box.bottom <= frame.bottom;
}

// Possible sides of a text, seen from its mark: -1, 0 or 1 in x and in y. Right comes before left,
// since texts are read from there.
constexpr std::array<Point, 8> sides{
    {{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {1, 1}, {-1, -1}, {-1, 1}}};

Box beside(const WantedLabel& label, Point side, double away) {
  const double reach = label.radius + gap + away;
  // Diagonally the corner of the text is near, not its side.
  const double share = side.x != 0 && side.y != 0 ? 0.7 : 1;
  const double x = label.at.x + side.x * (share * reach + label.width / 2);
  const double y = label.at.y + side.y * (share * reach + label.height / 2);
  return {x - label.width / 2, y - label.height / 2, x + label.width / 2, y + label.height / 2};
}

std::size_t covered(const Box& box, const std::vector<Box>& marks) {
  return static_cast<std::size_t>(
      std::ranges::count_if(marks, [&](const Box& mark) { return overlap(box, mark, 0); }));
}

std::optional<PlacedLabel> best_place(const WantedLabel& label, const std::vector<Box>& marks,
                                      const std::vector<Box>& taken, const Box& frame) {
  std::optional<PlacedLabel> best;
  std::size_t fewest = 0;
  for (const double ring : rings) {
    for (const Point& side : sides) {
      const Box box = beside(label, side, ring);
      const auto in_the_way = [&](const Box& other) { return overlap(box, other, gap); };
      if (!within(box, frame) || std::ranges::any_of(taken, in_the_way)) continue;
      const std::size_t covers = covered(box, marks);
      if (best && covers >= fewest) continue;
      best = PlacedLabel{box, ring > 0};
      fewest = covers;
      if (covers == 0) return best;
    }
  }
  return best;
}

}  // namespace

double line_of(double size) { return size + 3; }

ChartText cut(const std::string& text, double size, Weight weight, double width) {
  ChartText result{{{}, text, size, weight}, false, ""};
  if (width_of(result) <= width) return result;
  result.whole = text;
  std::string kept = text;
  while (!kept.empty() && width_of(result) > width) {
    shorten(kept);
    result.drawn.text = kept + "…";
  }
  return result;
}

std::vector<ChartText> broken(const std::string& text, double size, Weight weight, double width,
                              std::size_t most) {
  std::vector<std::string> lines = wrap(text, size, weight == Weight::bold, width);
  const bool too_many = lines.size() > most;
  if (too_many) {
    for (std::size_t i = most; i < lines.size(); ++i) lines[most - 1] += lines[i];
    lines.resize(most);
  }
  std::vector<ChartText> result;
  for (std::string& line : lines) {
    line.erase(line.find_last_not_of(' ') + 1);
    result.push_back(cut(line, size, weight, width));
    if (!result.back().whole.empty()) result.back().whole = text;
  }
  return result;
}

ChartText at(ChartText text, Point point, Align align) {
  const double width = width_of(text);
  const double left = begin(point.x, width, align);
  text.drawn.align = align;
  text.drawn.box = {left, point.y, left + width, point.y + line_of(text.drawn.size)};
  return text;
}

// Reading upward, a text starts at the bottom.
ChartText turned_at(ChartText text, Point point, Align align) {
  const double length = width_of(text);
  const double bottom = -begin(-point.y, length, align);
  text.turned = true;
  text.drawn.align = align;
  text.drawn.box = {point.x, bottom - length, point.x + line_of(text.drawn.size), bottom};
  return text;
}

void shift(ChartText& text, double dx, double dy) {
  Box& box = text.drawn.box;
  box = {box.left + dx, box.top + dy, box.right + dx, box.bottom + dy};
}

Box around(const Box& a, const Box& b) {
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

std::vector<std::optional<PlacedLabel>> place_labels(const std::vector<WantedLabel>& wanted,
                                                     const std::vector<Box>& marks,
                                                     const Box& frame) {
  std::vector<std::optional<PlacedLabel>> placed;
  std::vector<Box> taken;
  for (const WantedLabel& label : wanted) {
    placed.push_back(best_place(label, marks, taken, frame));
    if (placed.back()) taken.push_back(placed.back()->box);
  }
  return placed;
}

}  // namespace reeve::drawing::chart
