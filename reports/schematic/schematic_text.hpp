// The texts of a schematic that are no labels of segments, and their places.
#pragma once

#include <string>

#include "reports/schematic/schematic_layout.hpp"

namespace reeve::reports {

// Title and subtitle at the top; returns where the drawing may begin.
double add_heading(const SchematicFrame& frame, SchematicLayout& layout);

// Over the fingertip, or over what holds it.
void add_finger_name(int number, const DrawnFinger& finger, SchematicLayout& layout);

// Beside the arrow at the carriage: its place and size.
DrawnText motor_text(const SchematicLayout& layout);

}  // namespace reeve::reports
