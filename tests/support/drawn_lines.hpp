// Lines and boxes of a drawing, for the tests of its geometry.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "drawing/schematic/schematic_layout.hpp"

namespace reeve::testing {

struct Edge {
  Point from;
  Point to;
};

struct Item {
  std::string name;  // parts of one thing share it
  Box box;
};

std::string text(const Box& box);
bool overlap(const Box& a, const Box& b);
bool same(Point a, Point b);
Box around(const Edge& edge, double room);

// The straight pieces alone, or with the roundings as short chords.
std::vector<Edge> edges(const DrawnSegment& segment, bool rounded);

// Calls visit(level line, upright line, inside) for every two pieces of different segments;
// `inside`: how far within both the place lies where their lines cross, negative if without.
template <typename Visit>
void for_each_meeting(const SchematicLayout& layout, Visit visit) {
  for (const DrawnSegment& one : layout.segments) {
    for (const DrawnSegment& other : layout.segments) {
      if (&one == &other) continue;
      for (const Edge& level : edges(one, false)) {
        if (level.from.y != level.to.y) continue;
        const Box across = around(level, 0);
        for (const Edge& upright : edges(other, false)) {
          if (upright.from.x != upright.to.x) continue;
          const Box up = around(upright, 0);
          const double x = upright.from.x;
          const double y = level.from.y;
          visit(one, other,
                std::min({x - across.left, across.right - x, y - up.top, up.bottom - y}));
        }
      }
    }
  }
}

// How often lines of different segments cross.
std::size_t crossings(const SchematicLayout& layout);

}  // namespace reeve::testing
