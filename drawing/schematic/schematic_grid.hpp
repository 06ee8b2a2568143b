// The heights and widths of a schematic: where its columns and rows lie.
#pragma once

#include <vector>

#include "core/grasp.hpp"
#include "core/network.hpp"
#include "drawing/schematic/schematic_plan.hpp"

namespace reeve::drawing {

// A row of arcs: lines come in along the lane and turn round the centre.
struct ArcRow {
  double lane = 0;
  double centre = 0;
};

struct FingerHeights {
  double top = 0;     // of the outline
  double centre = 0;  // of the turn at the tip
};

struct FingerRow {
  std::vector<FingerHeights> fingers;
  double base = 0;  // where the palm begins
};
FingerRow finger_row(int fingers, Grasp held, double top);

struct SchematicGrid {
  double left = 0;  // what the blocks take
  double right = 0;
  std::vector<double> column;  // x
  std::vector<FingerHeights> fingers;
  double finger_base = 0;
  double arch = 0;   // top of the stretches at the hand
  double fixed = 0;  // where strands are fixed
  std::vector<ArcRow> hand_rows;
  double hand_bottom = 0;
  double sheath = 0;  // its middle
  double motor_labels = 0;
  double carriage_top = 0;
  double tied = 0;
  std::vector<ArcRow> carriage_rows;
  double carriage_bottom = 0;
};

// From `top` downward, the blocks beginning at x = 0.
SchematicGrid grid(const Network& network, const SchematicPlan& plan, Grasp held, double top);

// The turn of an arc: between its two legs.
struct Turn {
  double centre = 0;  // x
  double radius = 0;
};
Turn turn(const Arc& arc, const SchematicPlan& plan, const SchematicGrid& grid);

}  // namespace reeve::drawing
