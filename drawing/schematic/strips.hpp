// What keeps others away: upright strips of a drawing with floating parts, each at a place of its
// fitting and over some heights.
#pragma once

#include <vector>

#include "drawing/schematic/heights.hpp"

namespace reeve::drawing {

struct Strip {
  std::size_t fitting = 0;  // whose middle it moves with
  double rank = 0;
  double left = 0;  // from that middle, rightward
  double right = 0;
  double top = 0;
  double bottom = 0;
  std::size_t segment = nowhere;  // of a line
  bool rises = false;             // of a line: from its stretch upward
};

// The fitting on whose column a port lies, and how far right of its middle.
struct ColumnOf {
  std::size_t fitting = 0;
  double offset = 0;
};
ColumnOf column_of(const Fittings& all, std::size_t port);

std::vector<Strip> strips(const Network& network, const Fittings& all, const Lanes& lanes,
                          const FloatingHeights& heights, const Ranks& ranks);

}  // namespace reeve::drawing
