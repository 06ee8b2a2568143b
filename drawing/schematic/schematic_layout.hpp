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
#include "drawing/schematic/places.hpp"
#include "drawing/shapes.hpp"

namespace reeve::drawing {

struct DrawnSegment {
  std::string name;
  std::size_t tendon = 0;
  std::vector<Corner> path;  // points in walk order, from contact to contact or to the tendon's end
  Box label;                 // name and, below it, tension
  Align align = Align::start;
};

// A turn (tip, join, movable pulley or pass of a block) has its tendon on a half circle; a sheath
// is straight; a bar has its pivot as its centre.
struct DrawnContact {
  ContactKind kind = ContactKind::tube;
  ContactPlace place = ContactPlace::tip;
  Point centre;
  double radius = 0;      // radius of a turn
  double apex = 1;        // turns: 1 if it bulges downward, -1 upward
  double length = 0;      // length of a sheath
  double arrow_side = 1;  // sheaths: side with room for an arrow, right (1) or left (-1)
  // True if the walk passes it from left to right; for a sheath, downward.
  bool forward = true;
};

enum class EndHold : std::uint8_t {
  fixed,     // held at the hand
  tied,      // held at the carriage
  anchored,  // held at a fingertip
  extensor,  // held at its back
  block,     // held at a block's eye or a bar's hole
};

// End of a tendon.
struct DrawnEnd {
  EndHold hold = EndHold::fixed;
  Point at;
  double away = 1;  // the part that holds it lies below (1) or above (-1)
};

// A floating block: sheaves side by side in one shell, which narrows to the eye of its tail; or a
// bar with the ends of its arms and its pivot. Beckets are eyes beside the sheaves.
struct DrawnBlock {
  bool is_bar = false;
  double apex = 1;           // its tails lie below (1) or above (-1)
  std::vector<Point> axles;  // axles of its sheaves
  double sheave = 0;         // their radius
  std::vector<Point> eyes;   // eyes of beckets, or ends of the arms
  std::vector<Point> tails;  // the eyes of its tails, or the pivot
  double beam = 0;           // height of the beam that joins these
  Box motion;                // room for an arrow in its direction of motion
};

// A carriage. One whose tendons stand apart is drawn in parts; where tendons of several motors
// cross on their carriages, these are drawn as one box.
struct DrawnCarriage {
  int motor = 1;
  Box box;
  Box arrow;       // arrow of the motor, from top to bottom
  DrawnText text;  // its place; the text depends on what is shown
};

struct DrawnFinger {
  Box outline;
  bool held = false;
  Box object;  // the object that holds it, if it is held
};

enum class LegendSymbol : std::uint8_t {
  tube,
  bearing,
  sheath,
  fixed,
  tied,
  anchored,
  extensor,
  block,
  bar,
  slides,
  slack,
};

// Parts drawn; the legend explains only these.
struct DrawnParts {
  bool tubes = false;
  bool bearings = false;
  bool sheaths = false;
  bool fixed = false;
  bool tied = false;
  bool anchors = false;
  bool extensors = false;
  bool blocks = false;
  bool bars = false;
  bool slack = false;

  friend bool operator==(const DrawnParts&, const DrawnParts&) = default;
  DrawnParts& operator|=(const DrawnParts& other);
};

struct LegendItem {
  LegendSymbol symbol = LegendSymbol::tube;
  Box box;  // box of the symbol
};

struct Legend {
  std::vector<LegendItem> items;
  std::vector<DrawnText> texts;
  double bottom = 0;
};

// Parallel to the network's segments, contacts, blocks and fingers.
struct SchematicLayout {
  std::string title;
  std::string subtitle;
  DrawnParts parts;  // slack, which does not show in a layout, is not among them
  double width = 0;
  double height = 0;
  std::vector<DrawnSegment> segments;
  std::vector<DrawnContact> contacts;
  std::vector<DrawnBlock> blocks;
  std::vector<DrawnEnd> ends;
  std::vector<DrawnFinger> fingers;
  Box hand;
  std::vector<DrawnCarriage> carriages;  // sorted from left to right
  std::vector<DrawnText> texts;
  Legend legend;
};

struct SchematicFrame {
  std::string title;  // broken where it is wider than the drawing
  std::string subtitle;
  Grasp held;
  bool with_legend = true;
  bool with_tension = true;  // true if the legend explains marks that only tensions show
  bool with_slack = true;    // among it strands without any
};

// Uses the given places of this network, so that several grasps share them.
SchematicLayout layout(const Network& network, const SchematicFrame& frame, const Places& places);
SchematicLayout layout(const Network& network, const SchematicFrame& frame);

// Slack is not among them.
DrawnParts drawn_parts(const Network& network);

// The symbols' meanings, flowing between left and right.
Legend legend(const Box& room, bool with_tension, const DrawnParts& parts);

}  // namespace reeve::drawing
