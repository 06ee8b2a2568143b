// The drawing of a routing with floating blocks, bars or anchored tips.
//
// Fingers stand at the top. Below, in the palm, blocks and joins lie in levels, each where its
// lines run straight, upright or inverted (facing.hpp), in an order with few crossings
// (arrangement.hpp); then come the sheaths and the carriage. A line runs down from a port to a lane
// between two levels, along it and on (lanes.hpp); whatever passes the same height keeps its
// distance (columns.hpp). So no line lies on another or under a symbol or a text, and lines cross
// at right angles only.
#pragma once

#include "drawing/schematic/arrangement.hpp"
#include "drawing/schematic/schematic_layout.hpp"

namespace reeve::drawing {

// The same in all grasps, and what takes long.
struct FloatingPlan {
  Fittings fittings;
  Arrangement arrangement;  // with the palm at height 0
};

FloatingPlan floating_plan(const Network& network);

SchematicLayout floating_layout(const Network& network, const SchematicFrame& frame,
                                const FloatingPlan& plan);

}  // namespace reeve::drawing
