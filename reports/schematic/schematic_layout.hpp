// The geometry of a routing's schematic: where everything lies, in pixels, y downward; no colour,
// no line width, no number. schematic_svg.hpp draws it.
//
// Fingers stand side by side with their two strands, which turn at the tip. Joins and fixations lie
// in the hand below; sheaths lead from there to the carriage, which bears what is tied to it and
// the movable pulleys. schematic_plan.hpp says what stands beside what.
//
// Lines are axis-parallel with rounded corners and lie apart from each other except where they
// cross at a right angle. No text overlaps a line, a symbol or another text.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/grasp.hpp"
#include "core/network.hpp"
#include "reports/shapes.hpp"

namespace reeve::reports {

struct DrawnSegment {
  std::string name;
  std::size_t tendon = 0;
  std::vector<Corner> path;  // in walk order, from contact to contact or to where it ends
  Box label;                 // name and, below it, tension
  Align align = Align::start;
};

// A turn (tip, join or movable pulley) has its tendon on a half circle; a sheath is straight.
struct DrawnContact {
  ContactKind kind = ContactKind::tube;
  ContactPlace place = ContactPlace::tip;
  Point centre;
  double radius = 0;      // of a turn
  double apex = 1;        // of a turn: 1 if it bulges downward, -1 upward
  double length = 0;      // of a sheath
  double arrow_side = 1;  // of a sheath: where there is room for an arrow, right (1) or left (-1)
  // Whether the walk passes it from left to right; a sheath: downward.
  bool forward = true;
};

// Where a tendon ends.
struct DrawnEnd {
  bool tied = false;  // to the carriage; otherwise fixed at the hand
  Point at;
  double away = 1;  // what holds it lies below (1) or above (-1)
};

struct DrawnFinger {
  Box outline;
  bool held = false;
  Box object;  // what holds it, if it is held
};

enum class LegendSymbol : std::uint8_t { tube, bearing, sheath, fixed, tied, slides, slack };

struct LegendItem {
  LegendSymbol symbol = LegendSymbol::tube;
  Box box;  // of the symbol
};

struct Legend {
  std::vector<LegendItem> items;
  std::vector<DrawnText> texts;
  double bottom = 0;
};

// Parallel to the network's segments, contacts and fingers.
struct SchematicLayout {
  std::string title;
  std::string subtitle;
  double width = 0;
  double height = 0;
  std::vector<DrawnSegment> segments;
  std::vector<DrawnContact> contacts;
  std::vector<DrawnEnd> ends;
  std::vector<DrawnFinger> fingers;
  Box hand;
  Box carriage;          // empty if nothing hangs on it
  Box motor;             // the arrow at the carriage, from top to bottom
  DrawnText motor_text;  // its place; the text depends on what is shown
  std::vector<DrawnText> texts;
  Legend legend;
};

struct SchematicFrame {
  std::string title;  // broken where it is wider than the drawing
  std::string subtitle;
  Grasp held;
  bool with_legend = true;
  bool with_tension = true;  // whether the legend explains what only tensions show
};

SchematicLayout layout(const Network& network, const SchematicFrame& frame);

// The symbols' meanings, flowing between left and right.
Legend legend(const Box& room, bool with_tension);

// What a symbol covers.
Box bounds(const DrawnContact& contact);
Box bounds(const DrawnEnd& end);

}  // namespace reeve::reports
