// The texts of a schematic, their places, and the carriage with its text.
#pragma once

#include <string>

#include "drawing/schematic/schematic_layout.hpp"

namespace reeve::drawing {

// Title and subtitle at the top; returns where the drawing may begin.
double add_heading(const SchematicFrame& frame, SchematicLayout& layout);

// Over the fingertip, or over what holds it.
void add_finger_name(int number, const DrawnFinger& finger, SchematicLayout& layout);

// Beside the line at x.
void place_label(double x, double top, bool to_the_right, DrawnSegment& drawn);

// Below what hangs on it, from its leftmost to its rightmost line, with the motor's arrow and text.
void place_carriage(double left, double right, double top, double bottom, SchematicLayout& layout);

}  // namespace reeve::drawing
