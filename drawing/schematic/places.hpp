// Layout of a schematic that no grasp changes: places of ports, lines and labels.
//
// There are two such layouts. A hand without floating parts has its columns in the order of the
// fingers and its joins in rows below each other (rows.cpp). With blocks, bars or anchored tips,
// blocks and joins lie in levels, in an order that is searched for (arrangement.cpp).
#pragma once

#include <vector>

#include "drawing/schematic/fittings.hpp"
#include "drawing/schematic/schematic_measures.hpp"
#include "drawing/shapes.hpp"

namespace reeve::drawing {

// A level piece of a line.
struct LevelPiece {
  double y = 0;
  double from = 0;  // x, in walk order
  double to = 0;
  double rounding = measures::bend;  // rounding of its two corners, if there is room
};

// `start`: right of the line at that x, `end`: left of it, `middle`: under it.
struct LabelPlace {
  Point top;
  Align align = Align::start;
};

// x from the leftmost part, y from where the palm begins.
struct Places {
  Fittings fittings;
  double width = 0;
  std::vector<double> fingers;  // the middle of each
  std::vector<Point> ports;     // the fingertips' y depends on the grasp
  // Parallel to the segments:
  std::vector<std::vector<LevelPiece>> pieces;
  std::vector<Point> loose;        // place that holds an end without a port
  std::vector<LabelPlace> labels;  // the strands' stand in their fingers
  Box hand;
  double carriage_top = 0;
  double bottom = 0;  // bottom of the carriage, or of the hand without one

  explicit Places(Fittings placed);
};

Places places_in_rows(const Network& network, Fittings fittings);
Places places_in_levels(const Network& network, Fittings fittings);

// Uses the layout that the network needs.
Places places(const Network& network);

}  // namespace reeve::drawing
