// Places and texts of drawings, in pixels, y downward.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::drawing {

struct Point {
  double x = 0;
  double y = 0;
};

struct Box {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;
};

struct Corner {
  Point at;
  double radius = 0;  // radius of the rounding
};

enum class Align : std::uint8_t { start, middle, end };

enum class Weight : std::uint8_t { normal, bold };

struct DrawnText {
  Box box;
  std::string text;
  double size = 0;
  Weight weight = Weight::normal;
  Align align = Align::start;
};

namespace measures {

// A generous guess, for any sans-serif font.
double text_width(const std::string& text, double size, bool bold);

}  // namespace measures

// Breaks behind spaces, '-' and '+' where a line would grow wider.
std::vector<std::string> wrap(const std::string& text, double size, bool bold, double width);

}  // namespace reeve::drawing
