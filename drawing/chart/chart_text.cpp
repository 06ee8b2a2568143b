#include "drawing/chart/chart_text.hpp"

#include <algorithm>

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

// Where a stretch of this length begins that is aligned to `at`.
double begin(double at, double length, Align align) {
  switch (align) {
    case Align::start:
      return at;
    case Align::middle:
      return at - length / 2;
    case Align::end:
      return at - length;
  }
  return at;
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

}  // namespace reeve::drawing::chart
