// Pieces of SVG text. Colours are presentation attributes, which every viewer, converter and style
// sheet can deal with; `currentColor` is the ink.
#pragma once

#include <string>
#include <vector>

#include "drawing/shapes.hpp"

namespace reeve::drawing::svg {

// Text and attribute values; control characters, which XML cannot hold, become spaces.
std::string escape(const std::string& text);

// Formats with at most two decimals and no trailing zeros.
std::string number(double value);

// " name="value""; the value is escaped, or has nothing to escape.
std::string attribute(const char* name, const std::string& value);

// Joins the texts that `draw` makes of the items.
template <typename Items, typename Draw>
std::string each(const Items& items, Draw draw) {
  std::string all;
  for (const auto& item : items) all += draw(item);
  return all;
}

std::string line(Point from, Point to);
std::string circle(Point centre, double radius, const std::string& attributes = "");
std::string rectangle(const Box& box, double rounding, const std::string& attributes = "");
std::string path(const std::string& commands, const std::string& attributes = "");
std::string group(const std::string& attributes, const std::string& content);
std::string text(const DrawnText& text);
// x at which a text is anchored in its box, and the attribute that says so.
double anchor(const Box& box, Align align);
const char* anchor(Align align);

// The commands of a path with rounded corners.
std::string rounded(const std::vector<Corner>& path);

std::string move_to(Point at);
std::string line_to(Point at);
// A circular arc of less than half a turn or half a turn.
std::string arc_to(Point at, double radius, bool clockwise);

}  // namespace reeve::drawing::svg
