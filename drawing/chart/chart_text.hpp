// The texts of a chart: cut and broken to the room that they have, and put beside their marks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/shapes.hpp"

namespace reeve::drawing::chart {

struct ChartText {
  DrawnText drawn;
  bool turned = false;  // it reads upward; the box is as it lies, so higher than wide
  std::string whole;    // the whole text, if it was cut
};

inline constexpr double small_text = 12;
inline constexpr double title_text = 13;
inline constexpr double heading_text = 14;

// Height of a text of one line.
double line_of(double size);

// Cuts a text to `width`, behind a character, with "…" for the rest.
ChartText cut(const std::string& text, double size, Weight weight, double width);

// Breaks a text into at most `most` lines of that width, each cut if need be.
std::vector<ChartText> broken(const std::string& text, double size, Weight weight, double width,
                              std::size_t most);

// Puts a text's box there: the point is its top (turned: its left) at the side that it is aligned
// to.
ChartText at(ChartText text, Point point, Align align);
ChartText turned_at(ChartText text, Point point, Align align);

void shift(ChartText& text, double dx, double dy);

// The box round both.
Box around(const Box& a, const Box& b);

struct WantedLabel {
  Point at;           // place of its mark
  double radius = 0;  // radius of its mark
  double width = 0;   // width of the text
  double height = 0;
};

struct PlacedLabel {
  Box box;
  bool needs_leader = false;  // so far from its mark that a line has to tell whose it is
};

// Places for texts beside their marks, so that none lies over another and none leaves the frame.
//
// One text after the other takes the first of the places round its mark, near ones first, that
// covers no mark, or else the one that covers fewest. What is placed stays: greedy, so not the best
// arrangement of all, but the same each time, and good where labels are few.
//
// Parallel to `wanted`; nothing for a text that has no room. `marks`: what had better stay visible.
std::vector<std::optional<PlacedLabel>> place_labels(const std::vector<WantedLabel>& wanted,
                                                     const std::vector<Box>& marks,
                                                     const Box& frame);

}  // namespace reeve::drawing::chart
