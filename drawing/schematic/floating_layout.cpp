#include "drawing/schematic/floating_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "drawing/schematic/facing.hpp"
#include "drawing/schematic/floating_measures.hpp"
#include "drawing/schematic/floating_paths.hpp"
#include "drawing/schematic/schematic_grid.hpp"
#include "drawing/schematic/schematic_text.hpp"

namespace reeve::drawing {

namespace measures {

std::string block_title(const core::Block& block) {
  const ArmRatio& arms = block.arms;
  if (arms.left == arms.right) return block_name(block);
  return fmt::format("{} {}:{}", block_name(block), arms.left, arms.right);
}

double name_width(const core::Block& block) {
  return text_width(block_title(block), small_size, true);
}

}  // namespace measures

namespace {

using namespace measures;

class FloatingLayouter {
 public:
  FloatingLayouter(const Network& network, const SchematicFrame& frame, const FloatingPlan& plan)
      : net_(network),
        frame_(frame),
        all_(plan.fittings),
        arrangement_(plan.arrangement),
        places_{network, all_, arrangement_, {}, 0} {}

  SchematicLayout run() {
    const double content = arrangement_.columns.right;
    out_.width = std::max(least_width, content + 2 * (margin + flesh));
    const double top = add_heading(frame_, out_);
    const FingerRow row = finger_row(net_.fingers, frame_.held, top);
    move_down(row.base);
    places_.left = std::floor((out_.width - content) / 2);
    out_.title = frame_.title;
    out_.subtitle = frame_.subtitle;
    out_.parts = drawn_parts(net_);
    add_fingers(row);
    for (std::size_t i = 0; i < net_.contacts.size(); ++i) add_contact(i);
    for (std::size_t i = 0; i < net_.blocks.size(); ++i) add_block(i);
    for (std::size_t i = 0; i < net_.segments.size(); ++i) add_segment(i);
    out_.hand = {places_.left - flesh / 2, row.base, places_.left + content + flesh / 2,
                 arrangement_.heights.hand_bottom};
    add_carriage();
    out_.height = arrangement_.heights.bottom + margin;
    if (out_.motor.bottom > 0) out_.height = out_.motor.bottom + margin;
    if (frame_.with_legend) add_legend();
    return std::move(out_);
  }

 private:
  // Everything was planned with the palm at 0.
  void move_down(double by) {
    FloatingHeights& heights = arrangement_.heights;
    for (double& level : heights.level) level += by;
    for (ChannelHeights& channel : heights.channel) {
      for (double* y : {&channel.top, &channel.lanes, &channel.below, &channel.bottom}) *y += by;
    }
    for (double* y :
         {&heights.hand_bottom, &heights.carriage_top, &heights.tied, &heights.bottom}) {
      *y += by;
    }
  }

  void add_fingers(const FingerRow& row) {
    for (std::size_t f = 0; f < row.fingers.size(); ++f) {
      const int number = static_cast<int>(f) + 1;
      const FingerHeights& heights = row.fingers[f];
      const bool anchored = is_anchored(net_, number);
      places_.fingertips.push_back(anchored ? heights.top + anchor_depth : heights.centre);
      const double middle = places_.left + arrangement_.columns.middle[f];
      const double half = pitch / 2 + flesh;
      const bool held = frame_.held.holds(number);
      const Box object{middle - object_size / 2, heights.top - 1 - object_size,
                       middle + object_size / 2, heights.top - 1};
      out_.fingers.push_back(
          {{middle - half, heights.top, middle + half, row.base}, held, held ? object : Box{}});
      add_finger_name(number, out_.fingers.back(), out_);
    }
  }

  void add_contact(std::size_t i) {
    const Contact& contact = net_.contacts[i];
    const auto [in, out] = all_.turns[i];
    DrawnContact drawn;
    drawn.kind = contact.kind;
    drawn.place = contact.place;
    const Point from = places_.at(in);
    const Point to = places_.at(out);
    drawn.centre = {(from.x + to.x) / 2, from.y};
    drawn.apex = all_.faces_down(in) ? -1 : 1;
    drawn.forward = from.x < to.x;
    if (contact.place == ContactPlace::sheath) {
      drawn.length = sheath_length;
      drawn.forward = all_.ports[in].role == PortRole::hand_side;
    } else if (contact.kind == ContactKind::bar) {
      drawn.centre = tail_of(contact.block);
    } else {
      drawn.radius = tip_radius;
    }
    out_.contacts.push_back(drawn);
  }

  Point tail_of(std::size_t block) const {
    for (const std::size_t port : all_.fittings[all_.blocks[block]].ports) {
      if (is_tail(all_.ports[port].role)) return places_.at(port);
    }
    return {};
  }

  void add_block(std::size_t i) {
    const core::Block& block = net_.blocks[i];
    const Fitting& fitting = all_.fittings[all_.blocks[i]];
    DrawnBlock drawn;
    drawn.is_bar = block.is_bar;
    drawn.apex = fitting.inverted ? -1 : 1;
    drawn.sheave = tip_radius - thickest / 2 - 1;
    for (const std::size_t port : fitting.ports) {
      const FittingPort& at = all_.ports[port];
      if (at.role == PortRole::turn) {
        if (port < at.twin) drawn.axles.push_back(places_.centre(port));
      } else if (is_tail(at.role)) {
        drawn.tails.push_back(places_.at(port));
      } else {
        drawn.eyes.push_back(places_.at(port));
      }
    }
    const double middle = arrangement_.heights.level[fitting.level];
    drawn.beam = block.is_bar ? middle : middle + drawn.apex * beam_depth;
    const double x = places_.left + arrangement_.columns.middle[all_.blocks[i]];
    const double half = block.is_bar ? bar_half : beam_half;
    const double beside = drawn.beam + drawn.apex * (half + 2 + name_height / 2);
    const auto [first, last] = tails_of(all_, all_.blocks[i]);
    const double before = x + first - name_left;
    drawn.motion = {before - motion_width, beside - motion_length / 2, before,
                    beside + motion_length / 2};
    out_.blocks.push_back(drawn);
    const double left = x + last + name_left;
    out_.texts.push_back(
        {{left, beside - name_height / 2, left + name_width(block), beside + name_height / 2},
         block_title(block),
         small_size,
         Weight::bold,
         Align::start});
  }

  void add_segment(std::size_t i) {
    DrawnSegment drawn;
    drawn.name = segment_name(net_.segments[i]);
    drawn.tendon = all_.segments[i].tendon;
    drawn.path = path(places_, i);
    for (const std::size_t side : {0U, 1U}) add_end(i, side, drawn);
    if (net_.segments[i].kind == SegmentKind::strand) {
      label_strand(net_.segments[i], drawn);
    } else {
      const std::size_t port = labelled_port(net_, all_, i);
      place_label(places_.at(port).x, label_top(all_, arrangement_.heights, port), true, drawn);
    }
    out_.segments.push_back(std::move(drawn));
  }

  void add_end(std::size_t segment, std::size_t side, const DrawnSegment& drawn) {
    const SegmentEnds& ends = all_.segments[segment];
    const Point at = (side == 0 ? drawn.path.front() : drawn.path.back()).at;
    const std::size_t port = ends.port[side];
    if (port == nowhere) {
      const bool tied = ends.loose == LooseEnd::tied;
      const double away = all_.faces_down(ends.port[1 - side]) ? 1 : -1;
      out_.ends.push_back({tied ? EndHold::tied : EndHold::fixed, at, away});
      return;
    }
    const PortRole role = all_.ports[port].role;
    if (role == PortRole::clamp) out_.ends.push_back({EndHold::fixed, at, -1});
    if (role == PortRole::strand && all_.ports[port].twin == nowhere) {
      out_.ends.push_back({EndHold::anchored, at, -1});
    } else if (is_tail(role) || role == PortRole::becket) {
      out_.ends.push_back({EndHold::block, at, 1});
    }
  }

  void label_strand(const Segment& strand, DrawnSegment& drawn) const {
    const auto f = static_cast<std::size_t>(strand.finger - 1);
    const double base = out_.fingers[f].outline.bottom;
    const double upper = base - 6 - label_height - label_step;
    const double middle = places_.left + arrangement_.columns.middle[f];
    if (is_anchored(net_, strand.finger)) {
      place_label(middle, upper, true, drawn);
      return;
    }
    const bool left = strand.number % 2 == 1;
    place_label(middle + (left ? -tip_radius : tip_radius), left ? upper : upper + label_step, left,
                drawn);
  }

  void add_carriage() {
    double left = out_.width;
    double right = 0;
    for (const Fitting& fitting : all_.fittings) {
      if (fitting.kind != FittingKind::sheath && fitting.kind != FittingKind::pulley) continue;
      for (const std::size_t port : fitting.ports) {
        left = std::min(left, places_.at(port).x);
        right = std::max(right, places_.at(port).x);
      }
    }
    if (right < left) return;
    place_carriage(left, right, arrangement_.heights.carriage_top, arrangement_.heights.bottom,
                   out_);
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
  const Fittings& all_;
  Arrangement arrangement_;
  FloatingPlaces places_;
  SchematicLayout out_;
};

}  // namespace

FloatingPlan floating_plan(const Network& network) {
  FloatingPlan plan{fittings(network), {}};
  face(plan.fittings);
  plan.arrangement = arrange(network, 0, plan.fittings);
  return plan;
}

SchematicLayout floating_layout(const Network& network, const SchematicFrame& frame,
                                const FloatingPlan& plan) {
  return FloatingLayouter(network, frame, plan).run();
}

}  // namespace reeve::drawing
