// The lines of a drawing with floating parts, once everything has its place.
#pragma once

#include <vector>

#include "drawing/schematic/arrangement.hpp"
#include "drawing/shapes.hpp"

namespace reeve::drawing {

struct FloatingPlaces {
  const Network& network;
  const Fittings& all;
  const Arrangement& arrangement;
  std::vector<double> fingertips;  // the middles of the turns there, or where tendons are tied
  double left = 0;                 // x of the leftmost

  Point at(std::size_t port) const;
  // Of a turn's half circle.
  Point centre(std::size_t port) const;
};

std::vector<Corner> path(const FloatingPlaces& places, std::size_t segment);

}  // namespace reeve::drawing
