#include "drawing/chart/chart_symbols.hpp"

#include <vector>

#include "drawing/svg.hpp"

namespace reeve::drawing::chart {
namespace {

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

}  // namespace

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

}  // namespace reeve::drawing::chart
