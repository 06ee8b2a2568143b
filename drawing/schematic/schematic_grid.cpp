#include "drawing/schematic/schematic_grid.hpp"

#include <algorithm>
#include <cmath>

#include "drawing/schematic/schematic_measures.hpp"

namespace reeve::drawing {
namespace {

using namespace measures;

void place_columns(const SchematicPlan& plan, SchematicGrid& grid) {
  double x = 0;
  for (const ColumnBlock& block : plan.blocks) {
    for (std::size_t i = 0; i < block.columns; ++i) {
      grid.column.push_back(x + pitch * static_cast<double>(i));
    }
    const bool widened = plan.widened[block.first_column + block.columns - 1];
    grid.right = x + pitch;
    x = grid.right + (widened ? widened_gap : block_gap);
  }
}

// Of a hand with three fingers or more, those in the middle are longer.
double reach_of_finger(int finger, int fingers) {
  constexpr double most = 22;
  if (fingers < 3) return 0;
  const double off = static_cast<double>(2 * finger - fingers - 1) / (fingers - 1);
  return most * (1 - off * off);
}

double place_rows(const std::vector<Arc>& arcs, const SchematicPlan& plan,
                  const SchematicGrid& grid, double top, std::vector<ArcRow>& placed) {
  constexpr double lane_to_centre = 2 * bend + 2;
  for (std::size_t row = 0; row < rows(arcs); ++row) {
    double radius = 0;
    bool straight = true;
    for (const Arc& arc : arcs) {
      if (arc.row != row) continue;
      const Turn turn = reports::turn(arc, plan, grid);
      radius = std::max(radius, turn.radius);
      straight = straight && grid.column[arc.left] == turn.centre - turn.radius &&
                 grid.column[arc.right] == turn.centre + turn.radius;
    }
    const double lane = top + 8;
    placed.push_back({lane, straight ? lane + 12 : lane + lane_to_centre});
    top = placed.back().centre + radius + sleeve + 4;
  }
  return top;
}

void place_hand(const SchematicPlan& plan, double top, SchematicGrid& grid) {
  double y = top;
  bool stretches = false;
  bool fixations = false;
  for (const ColumnBlock& block : plan.blocks) stretches = stretches || block.finger == 0;
  for (const Column& column : plan.columns) {
    fixations = fixations || column.foot == Foot::fixed;
  }
  grid.arch = y + 12;
  if (stretches) y = grid.arch + 20 + label_height;
  grid.fixed = y + 12;
  if (fixations) y = grid.fixed + fixation_depth + 4;
  y = place_rows(plan.hand_arcs, plan, grid, y, grid.hand_rows);
  constexpr double least = 34;
  grid.hand_bottom = std::max(y + 10, top + least);
}

void place_motor_side(const SchematicPlan& plan, const std::vector<SegmentPlan>& motor_side,
                      SchematicGrid& grid) {
  grid.sheath = grid.hand_bottom - 6 + sheath_length / 2;
  grid.motor_labels = grid.sheath + sheath_length / 2 + 8;
  grid.carriage_top = grid.motor_labels + label_step + label_height + 8;
  grid.tied = grid.carriage_top + 12;
  const bool tied = std::any_of(motor_side.begin(), motor_side.end(), [](const SegmentPlan& end) {
    return end.before == nowhere || end.after == nowhere;
  });
  const double y = tied ? grid.tied + knot_size / 2 + 2 : grid.carriage_top + 4;
  grid.carriage_bottom = place_rows(plan.carriage_arcs, plan, grid, y, grid.carriage_rows) + 8;
}

}  // namespace

Turn turn(const Arc& arc, const SchematicPlan& plan, const SchematicGrid& grid) {
  const double left = grid.column[arc.gap];
  const double right = grid.column[arc.gap + 1];
  const bool in_block = plan.columns[arc.gap].block == plan.columns[arc.gap + 1].block;
  return {(left + right) / 2, in_block ? tip_radius : turn_radius};
}

FingerRow finger_row(int fingers, Grasp held, double top) {
  constexpr double tip_to_labels = tip_radius + 4;
  if (fingers == 0) return {{}, top};
  double head = line_height + 4;  // its name
  if (held.held != 0) head += line_height + object_size + 2;
  double longest = 0;
  for (int f = 1; f <= fingers; ++f) longest = std::max(longest, reach_of_finger(f, fingers));
  FingerRow row;
  for (int f = 1; f <= fingers; ++f) {
    const double outline = top + head + longest - reach_of_finger(f, fingers);
    row.fingers.push_back({outline, outline + flesh + tip_radius});
  }
  row.base =
      top + head + longest + flesh + tip_radius + tip_to_labels + label_step + label_height + 8;
  return row;
}

SchematicGrid grid(const Network& network, const SchematicPlan& plan, Grasp held, double top) {
  SchematicGrid grid;
  place_columns(plan, grid);
  const FingerRow fingers = finger_row(network.fingers, held, top);
  grid.fingers = fingers.fingers;
  grid.finger_base = fingers.base;
  place_hand(plan, fingers.base, grid);
  std::vector<SegmentPlan> motor_side;
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    if (network.segments[i].kind == SegmentKind::motor_side) {
      motor_side.push_back(plan.segments[i]);
    }
  }
  if (!motor_side.empty()) {
    place_motor_side(plan, motor_side, grid);
  } else {
    grid.carriage_bottom = grid.hand_bottom;
  }
  return grid;
}

}  // namespace reeve::drawing
