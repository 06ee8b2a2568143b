// What stands beside what in a routing's schematic, before anything has a place in pixels.
//
// Every end of tendon that hangs down at the hand is a column. A finger is a block of two columns,
// its strands; a stretch at the hand (h1, …), which has no finger to run along, is a block of its
// own, with one column for each of its ends that leads to a contact. At its foot a column is fixed,
// joined to another column, or passes a sheath to the carriage.
//
// A join of two columns is an arc. Arcs that would lie over each other get rows of their own, the
// shorter ones on top, so that lines cross at right angles only. The turn itself, a tube or a
// wheel, sits in a gap between two neighbouring columns, where no other line runs.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/network.hpp"

namespace reeve::drawing {

inline constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

struct ColumnBlock {
  int finger = 0;  // 0: a stretch at the hand
  std::size_t first_column = 0;
  std::size_t columns = 0;
  double key = 0;           // blocks stand in this order
  std::size_t segment = 0;  // of a stretch at the hand
};

enum class Foot : std::uint8_t { fixed, joined, sheath };

struct Column {
  std::size_t block = 0;
  std::size_t segment = 0;
  Foot foot = Foot::fixed;
  std::size_t contact = nowhere;     // the join or the sheath
  std::size_t motor_side = nowhere;  // the segment below the sheath
};

// A turn that joins two columns, at the hand or on the carriage.
struct Arc {
  std::size_t contact = 0;
  std::size_t left = 0;  // columns
  std::size_t right = 0;
  std::size_t row = 0;     // 0: the topmost
  std::size_t gap = 0;     // the turn sits between this column and the next
  bool left_first = true;  // whether the walk comes from the left column
};

struct SegmentPlan {
  std::size_t tendon = 0;
  std::size_t before = nowhere;  // the contact at the segment's begin, in walk order
  std::size_t after = nowhere;
  // Columns of its begin and its end; a motor-side segment has the column of its sheath in both.
  std::array<std::size_t, 2> column{nowhere, nowhere};
};

struct SchematicPlan {
  std::vector<SegmentPlan> segments;  // parallel to the network's
  std::vector<ColumnBlock> blocks;
  std::vector<Column> columns;
  std::vector<Arc> hand_arcs;
  std::vector<Arc> carriage_arcs;
  std::vector<bool> widened;  // for each column: whether the gap behind it must hold a turn
};

SchematicPlan plan(const Network& network);

// Rows that these arcs take.
std::size_t rows(const std::vector<Arc>& arcs);

}  // namespace reeve::drawing
