#include "tests/support/drawn_lines.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::testing {
namespace {

Point between(Point a, Point b, double distance) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  return {a.x + (b.x - a.x) / length * distance, a.y + (b.y - a.y) / length * distance};
}

}  // namespace

std::string text(const Box& box) {
  return "[" + std::to_string(box.left) + ", " + std::to_string(box.top) + " – " +
         std::to_string(box.right) + ", " + std::to_string(box.bottom) + "]";
}

bool overlap(const Box& a, const Box& b) {
  constexpr double touch = 0.01;
  return a.left < b.right - touch && b.left < a.right - touch && a.top < b.bottom - touch &&
         b.top < a.bottom - touch;
}

bool same(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y) < 0.01; }

Box around(const Edge& edge, double room) {
  return {std::min(edge.from.x, edge.to.x) - room, std::min(edge.from.y, edge.to.y) - room,
          std::max(edge.from.x, edge.to.x) + room, std::max(edge.from.y, edge.to.y) + room};
}

std::vector<Edge> edges(const DrawnSegment& segment, bool rounded) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < segment.path.size(); ++i) {
    const Corner& corner = segment.path[i];
    if (!rounded || corner.radius == 0) {
      points.push_back(corner.at);
      continue;
    }
    const Point in = between(corner.at, segment.path[i - 1].at, corner.radius);
    const Point out = between(corner.at, segment.path[i + 1].at, corner.radius);
    const Point centre{in.x + out.x - corner.at.x, in.y + out.y - corner.at.y};
    constexpr int chords = 8;
    for (int k = 0; k <= chords; ++k) {
      const double angle = std::acos(0.0) * k / chords;
      points.push_back(
          {centre.x + (in.x - centre.x) * std::cos(angle) + (out.x - centre.x) * std::sin(angle),
           centre.y + (in.y - centre.y) * std::cos(angle) + (out.y - centre.y) * std::sin(angle)});
    }
  }
  std::vector<Edge> found;
  for (std::size_t i = 1; i < points.size(); ++i) found.push_back({points[i - 1], points[i]});
  return found;
}

std::size_t crossings(const SchematicLayout& layout) {
  std::size_t count = 0;
  for_each_meeting(layout, [&](const DrawnSegment&, const DrawnSegment&, double inside) {
    if (inside > 0) ++count;
  });
  return count;
}

}  // namespace reeve::testing
