#include "pages/exploration/exploration_spots.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "drawing/chart/chart_axis.hpp"

namespace reeve::pages {
namespace {

// Shares of the way from the least to the greatest.
double share(double value, const chart::Extent& extent) {
  return extent.high > extent.low ? (value - extent.low) / (extent.high - extent.low) : 0.5;
}

// Kind, column and line; known routings have cells of their own.
using GridCell = std::tuple<int, double, double>;

GridCell grid_cell(const PageDesign& design, std::size_t index, const Point& at,
                   const SpotGrid& grid) {
  const int kind = static_cast<int>(design.kind);
  if (design.kind == Kind::known) return {kind, static_cast<double>(index), 0};
  const double finer = design.kind == Kind::front ? 5 : 1;
  return {kind, std::round(at.x * grid.columns * finer), std::round(at.y * grid.lines * finer)};
}

// Turned so that greater is better.
Point turned(Point at, const TwoObjectives& axes) {
  const auto up = [](Objective objective) { return row(objective).better == Better::higher; };
  return {up(axes[0]) ? at.x : -at.x, up(axes[1]) ? at.y : -at.y};
}

}  // namespace

Point spot(const PageDesign& design, const TwoObjectives& axes) {
  return {value(design.values, axes[0]), value(design.values, axes[1])};
}

std::vector<DrawnDesign> thinned(const std::vector<PageDesign>& designs, const TwoObjectives& axes,
                                 const SpotGrid& grid) {
  chart::Extent x;
  chart::Extent y;
  for (const PageDesign& design : designs) {
    x.add(spot(design, axes).x);
    y.add(spot(design, axes).y);
  }
  std::vector<DrawnDesign> drawn;
  std::map<GridCell, std::size_t> cells;  // place in `drawn`
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const Point at = spot(designs[i], axes);
    const Point within{share(at.x, x), share(at.y, y)};
    const auto [found, is_new] =
        cells.try_emplace(grid_cell(designs[i], i, within, grid), drawn.size());
    if (is_new) {
      drawn.push_back({i, 1});
    } else {
      ++drawn[found->second].count;
    }
  }
  return drawn;
}

std::vector<Point> front_edge(const std::vector<Point>& front, const TwoObjectives& axes,
                              const std::vector<Point>& shown) {
  if (front.empty()) return {};
  std::vector<Point> sorted;
  for (const Point& at : front) sorted.push_back(turned(at, axes));
  std::sort(sorted.begin(), sorted.end(),
            [](const Point& a, const Point& b) { return a.x != b.x ? a.x > b.x : a.y > b.y; });
  std::vector<Point> edge;
  for (const Point& at : sorted) {
    if (edge.empty() || at.y > edge.back().y) edge.push_back(at);
  }
  Point worst = edge.back();
  for (const Point& at : shown) {
    worst.x = std::min(worst.x, turned(at, axes).x);
    worst.y = std::min(worst.y, turned(at, axes).y);
  }
  std::vector<Point> line{{edge.front().x, worst.y}};
  line.insert(line.end(), edge.begin(), edge.end());
  line.push_back({worst.x, edge.back().y});
  for (Point& at : line) at = turned(at, axes);
  return line;
}

}  // namespace reeve::pages
