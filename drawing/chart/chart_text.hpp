// A text of a chart, where it lies.
#pragma once

#include <string>
#include <vector>

#include "drawing/shapes.hpp"

namespace reeve::drawing::chart {

struct ChartText {
  DrawnText drawn;
  bool turned = false;  // it reads upward; the box is as it lies, so higher than wide
  std::string whole;    // where it was cut: all of it
};

inline constexpr double small_text = 12;
inline constexpr double title_text = 13;
inline constexpr double heading_text = 14;

// Of a text of one line.
double line_of(double size);

// At most `width` wide: cut behind a character, with "…" for what is missing.
ChartText cut(const std::string& text, double size, Weight weight, double width);

// Broken into at most `most` lines of that width, each cut if need be.
std::vector<ChartText> broken(const std::string& text, double size, Weight weight, double width,
                              std::size_t most);

// Puts a text's box there: the point is its top (turned: its left) at the side that it is aligned
// to.
ChartText at(ChartText text, Point point, Align align);
ChartText turned_at(ChartText text, Point point, Align align);

void shift(ChartText& text, double dx, double dy);

// The box round both.
Box around(const Box& a, const Box& b);

}  // namespace reeve::drawing::chart
