// Places for texts beside their marks, so that none lies over another and none leaves the frame.
//
// One text after the other takes the first of the places round its mark, near ones first, that
// covers no mark, or else the one that covers fewest. What is placed stays: greedy, so not the best
// arrangement of all, but the same each time, and good where labels are few.
#pragma once

#include <optional>
#include <vector>

#include "drawing/shapes.hpp"

namespace reeve::drawing::chart {

struct WantedLabel {
  Point at;           // of its mark
  double radius = 0;  // of its mark
  double width = 0;   // of the text
  double height = 0;
};

struct PlacedLabel {
  Box box;
  bool needs_leader = false;  // so far from its mark that a line has to tell whose it is
};

// Parallel to `wanted`; nothing for a text that has no room. `marks`: what had better stay visible.
std::vector<std::optional<PlacedLabel>> place_labels(const std::vector<WantedLabel>& wanted,
                                                     const std::vector<Box>& marks,
                                                     const Box& frame);

}  // namespace reeve::drawing::chart
