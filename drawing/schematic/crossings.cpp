#include "drawing/schematic/crossings.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::drawing {
namespace {

struct Piece {
  double at = 0;  // x of an upright piece, y of a level one
  double from = 0;
  double to = 0;
};

struct Pieces {
  std::vector<Piece> upright;
  std::vector<Piece> level;
};

Piece piece(double at, double a, double b) { return {at, std::min(a, b), std::max(a, b)}; }

Pieces pieces(const Fittings& all, const Lanes& lanes, const FloatingHeights& heights,
              const Columns& columns) {
  Pieces found;
  for (const Stretch& stretch : lanes.stretches) {
    const double y = height(heights, stretch);
    const double one = column(all, columns, stretch.port[0]);
    const double other = column(all, columns, stretch.port[1]);
    found.level.push_back(piece(y, one, other));
    for (const std::size_t end : {0U, 1U}) {
      const double x = end == 0 ? one : other;
      found.upright.push_back(piece(x, y, height(all, heights, stretch.port[end])));
    }
  }
  for (std::size_t i = 0; i < all.fittings.size(); ++i) {
    const Fitting& sheath = all.fittings[i];
    if (sheath.carrier == nowhere) continue;
    found.upright.push_back(piece(column(all, columns, sheath.carrier),
                                  height(all, heights, sheath.carrier),
                                  heights.level[sheath.level]));
  }
  return found;
}

}  // namespace

double cost(const Fittings& all, const Lanes& lanes, const FloatingHeights& heights,
            const Columns& columns) {
  const Pieces found = pieces(all, lanes, heights, columns);
  double cost = columns.right / 4 + heights.bottom / 4;
  for (const Piece& level : found.level) {
    cost += level.to - level.from;
    for (const Piece& upright : found.upright) {
      const bool cross = upright.at > level.from + 1 && upright.at < level.to - 1 &&
                         level.at > upright.from + 1 && level.at < upright.to - 1;
      if (cross) cost += cost_of_crossing;
    }
  }
  return cost;
}

}  // namespace reeve::drawing
