#include "drawing/schematic/schematic_layout.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drawing/schematic/fittings.hpp"
#include "drawing/schematic/floating_layout.hpp"
#include "drawing/schematic/schematic_grid.hpp"
#include "drawing/schematic/schematic_measures.hpp"
#include "drawing/schematic/schematic_plan.hpp"
#include "drawing/schematic/schematic_text.hpp"

namespace reeve::drawing {
namespace {

using namespace measures;
using Path = std::vector<Corner>;

class Layouter {
 public:
  Layouter(const Network& network, const SchematicFrame& frame)
      : net_(network), frame_(frame), plan_(plan(network)) {}

  SchematicLayout run() {
    const SchematicGrid measured = grid(net_, plan_, frame_.held, 0);
    out_.width = std::max(least_width, measured.right + 2 * (margin + flesh));
    const double top = add_heading(frame_, out_);
    grid_ = grid(net_, plan_, frame_.held, top);
    shift((out_.width - measured.right) / 2);
    out_.title = frame_.title;
    out_.subtitle = frame_.subtitle;
    out_.parts = drawn_parts(net_);
    out_.segments.resize(net_.segments.size());
    out_.contacts.resize(net_.contacts.size());
    add_hand_turns();
    add_fingers();
    for (std::size_t i = 0; i < net_.segments.size(); ++i) add_segment(i);
    out_.hand = {grid_.left - flesh, grid_.finger_base, grid_.right + flesh, grid_.hand_bottom};
    add_carriage();
    out_.height = grid_.carriage_bottom + margin;
    if (out_.motor.bottom > 0) out_.height = out_.motor.bottom + margin;
    if (frame_.with_legend) add_legend();
    return std::move(out_);
  }

 private:
  void shift(double by) {
    for (double& x : grid_.column) x += by;
    grid_.left += by;
    grid_.right += by;
  }

  void add_turns(const std::vector<Arc>& arcs, const std::vector<ArcRow>& rows) {
    for (const Arc& arc : arcs) {
      const Turn turn = reports::turn(arc, plan_, grid_);
      const Contact& contact = net_.contacts[arc.contact];
      out_.contacts[arc.contact] = {
          contact.kind,  contact.place, {turn.centre, rows[arc.row].centre}, turn.radius, 1, 0, 1,
          arc.left_first};
    }
  }

  void add_hand_turns() {
    add_turns(plan_.hand_arcs, grid_.hand_rows);
    add_turns(plan_.carriage_arcs, grid_.carriage_rows);
    for (std::size_t c = 0; c < plan_.columns.size(); ++c) {
      const Column& column = plan_.columns[c];
      if (column.foot != Foot::sheath) continue;
      const bool downward = plan_.segments[column.segment].after == column.contact;
      out_.contacts[column.contact] = {ContactKind::sheath,
                                       ContactPlace::sheath,
                                       {grid_.column[c], grid_.sheath},
                                       0,
                                       1,
                                       sheath_length,
                                       first_of_block(c) ? 1.0 : -1.0,
                                       downward};
    }
  }

  void add_fingers() {
    for (const ColumnBlock& block : plan_.blocks) {
      if (block.finger == 0) continue;
      const auto f = static_cast<std::size_t>(block.finger - 1);
      const double left = grid_.column[block.first_column];
      const FingerHeights heights = grid_.fingers[f];
      const Box outline{left - flesh, heights.top, left + pitch + flesh, grid_.finger_base};
      const double middle = left + pitch / 2;
      const bool held = frame_.held.holds(block.finger);
      const Box object{middle - object_size / 2, heights.top - 1 - object_size,
                       middle + object_size / 2, heights.top - 1};
      out_.fingers.push_back({outline, held, held ? object : Box{}});
      add_finger_name(block.finger, out_.fingers.back(), out_);
    }
    for (std::size_t i = 0; i < net_.contacts.size(); ++i) {
      const Contact& contact = net_.contacts[i];
      if (contact.place != ContactPlace::tip) continue;
      const auto f = static_cast<std::size_t>(contact.finger - 1);
      const Box& outline = out_.fingers[f].outline;
      out_.contacts[i] = {contact.kind,
                          contact.place,
                          {(outline.left + outline.right) / 2, grid_.fingers[f].centre},
                          tip_radius,
                          -1,
                          0,
                          1,
                          true};
    }
  }

  void add_segment(std::size_t i) {
    DrawnSegment& drawn = out_.segments[i];
    drawn.name = segment_name(net_.segments[i]);
    drawn.tendon = plan_.segments[i].tendon;
    switch (net_.segments[i].kind) {
      case SegmentKind::strand:
        add_strand(i, drawn);
        break;
      case SegmentKind::hand:
        add_stretch(i, drawn);
        break;
      case SegmentKind::motor_side:
        add_motor_side(i, drawn);
        break;
    }
  }

  void add_strand(std::size_t i, DrawnSegment& drawn) {
    const Segment& segment = net_.segments[i];
    const FingerHeights& heights = grid_.fingers[static_cast<std::size_t>(segment.finger - 1)];
    const bool left = segment.number % 2 == 1;
    const std::size_t c = plan_.segments[i].column[left ? 0 : 1];
    const double x = grid_.column[c];
    const double apex = heights.centre - tip_radius;
    drawn.path = {{{x + (left ? tip_radius : -tip_radius), apex}, 0}, {{x, apex}, tip_radius}};
    append(drawn.path, foot(c));
    if (left) std::reverse(drawn.path.begin(), drawn.path.end());
    const double upper = grid_.finger_base - 6 - label_height - label_step;
    place_label(x, left ? upper : upper + label_step, left, drawn);
  }

  // A stretch between two contacts bends over at its top; an end that is fixed is fixed there.
  void add_stretch(std::size_t i, DrawnSegment& drawn) {
    const auto [front, back] = plan_.segments[i].column;
    if (front != nowhere && back != nowhere) {
      const double left = grid_.column[front];
      const double right = grid_.column[back];
      drawn.path = foot(front);
      std::reverse(drawn.path.begin(), drawn.path.end());
      append(drawn.path, {{{left, grid_.arch}, pitch / 2}, {{right, grid_.arch}, pitch / 2}});
      append(drawn.path, foot(back));
      const double middle = (left + right) / 2;
      constexpr double half = 20;  // under the bend there is less room
      const double label = grid_.arch + 18;
      drawn.label = {middle - half, label, middle + half, label + label_height};
      drawn.align = Align::middle;
      return;
    }
    const std::size_t c = front != nowhere ? front : back;
    const Point top{grid_.column[c], grid_.arch + 4};
    drawn.path = {{top, 0}};
    append(drawn.path, foot(c));
    if (front != nowhere) std::reverse(drawn.path.begin(), drawn.path.end());
    out_.ends.push_back({EndHold::fixed, top, -1});
    place_label(top.x, grid_.arch + 18, true, drawn);
  }

  void add_motor_side(std::size_t i, DrawnSegment& drawn) {
    const SegmentPlan& segment = plan_.segments[i];
    const std::size_t c = segment.column[0];
    const double x = grid_.column[c];
    drawn.path = {{{x, grid_.sheath}, 0}};
    const bool sheath_first = segment.before == plan_.columns[c].contact;
    const std::size_t other = sheath_first ? segment.after : segment.before;
    if (other == nowhere) {
      drawn.path.push_back({{x, grid_.tied}, 0});
      out_.ends.push_back({EndHold::tied, {x, grid_.tied}, 1});
    } else {
      append(drawn.path, leg(c, other, plan_.carriage_arcs, grid_.carriage_rows));
    }
    if (!sheath_first) std::reverse(drawn.path.begin(), drawn.path.end());
    const bool first = first_of_block(c);
    place_label(x, grid_.motor_labels + (first ? 0 : label_step), first, drawn);
  }

  bool first_of_block(std::size_t c) const {
    return c == plan_.blocks[plan_.columns[c].block].first_column;
  }

  // From a column's line downward to where its segment ends.
  Path foot(std::size_t c) {
    const Column& column = plan_.columns[c];
    const double x = grid_.column[c];
    switch (column.foot) {
      case Foot::fixed:
        out_.ends.push_back({EndHold::fixed, {x, grid_.fixed}, 1});
        return {{{x, grid_.fixed}, 0}};
      case Foot::sheath:
        return {{{x, grid_.sheath}, 0}};
      case Foot::joined:
        break;
    }
    return leg(c, column.contact, plan_.hand_arcs, grid_.hand_rows);
  }

  Path leg(std::size_t c, std::size_t contact, const std::vector<Arc>& arcs,
           const std::vector<ArcRow>& rows) const {
    const auto arc =
        std::find_if(arcs.begin(), arcs.end(), [&](const Arc& a) { return a.contact == contact; });
    const Turn turn = reports::turn(*arc, plan_, grid_);
    const ArcRow& row = rows[arc->row];
    const double x = grid_.column[c];
    const double leg = turn.centre + (c == arc->left ? -turn.radius : turn.radius);
    const double apex = row.centre + turn.radius;
    Path path;
    const double aside = std::abs(leg - x);
    if (aside > 0.5) {
      const double radius = std::min(bend, aside / 2);
      path = {{{x, row.lane}, radius}, {{leg, row.lane}, radius}};
    }
    append(path, {{{leg, apex}, turn.radius}, {{turn.centre, apex}, 0}});
    return path;
  }

  static void append(Path& path, const Path& more) {
    path.insert(path.end(), more.begin(), more.end());
  }

  void add_carriage() {
    double left = out_.width;
    double right = 0;
    for (std::size_t c = 0; c < plan_.columns.size(); ++c) {
      if (plan_.columns[c].motor_side == nowhere) continue;
      left = std::min(left, grid_.column[c]);
      right = std::max(right, grid_.column[c]);
    }
    if (right < left) return;
    place_carriage(left, right, grid_.carriage_top, grid_.carriage_bottom, out_);
  }

  void add_legend() {
    const Box room{margin, out_.height - 2, out_.width - margin, 0};
    DrawnParts parts = out_.parts;
    parts.slack = frame_.with_slack;
    out_.legend = legend(room, frame_.with_tension, parts);
    out_.height = out_.legend.bottom + margin / 2;
  }

  const Network& net_;
  const SchematicFrame& frame_;
  SchematicPlan plan_;
  SchematicGrid grid_;
  SchematicLayout out_;
};

}  // namespace

LayoutPlan layout_plan(const Network& network) {
  if (!has_floating_parts(network)) return {};
  return {std::make_shared<const FloatingPlan>(floating_plan(network))};
}

SchematicLayout layout(const Network& network, const SchematicFrame& frame,
                       const LayoutPlan& plan) {
  if (plan.floating) return floating_layout(network, frame, *plan.floating);
  return Layouter(network, frame).run();
}

SchematicLayout layout(const Network& network, const SchematicFrame& frame) {
  return layout(network, frame, layout_plan(network));
}

}  // namespace reeve::drawing
