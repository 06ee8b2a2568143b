#include "drawing/schematic/schematic_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace reeve::drawing {
namespace {

using namespace measures;
using Path = std::vector<Corner>;

void append(Path& path, const Path& more) { path.insert(path.end(), more.begin(), more.end()); }

struct FingerHeights {
  double top = 0;     // top of the outline
  double centre = 0;  // centre of the turn at the tip
};

struct FingerRow {
  std::vector<FingerHeights> fingers;
  double base = 0;  // top of the palm
};

// The middle fingers of a hand with three or more are longer.
double reach_of_finger(int finger, int fingers) {
  constexpr double most = 22;
  if (fingers < 3) return 0;
  const double off = static_cast<double>(2 * finger - fingers - 1) / (fingers - 1);
  return most * (1 - off * off);
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

class Layouter {
 public:
  Layouter(const Network& network, const SchematicFrame& frame, const Places& places)
      : net_(network), frame_(frame), places_(places), all_(places.fittings) {}

  SchematicLayout run() {
    out_.title = frame_.title;
    out_.subtitle = frame_.subtitle;
    out_.parts = drawn_parts(net_);
    out_.width = std::max(least_width, places_.width + 2 * (margin + flesh));
    left_ = std::floor((out_.width - places_.width) / 2);
    const FingerRow row = finger_row(net_.fingers, frame_.held, add_heading());
    palm_ = row.base;
    for (int finger = 1; finger <= net_.fingers; ++finger) add_finger(finger, row);
    for (const TendonSpan& tendon : net_.tendons) {
      for (std::size_t k = 0; k < tendon.contacts; ++k) {
        const auto [in, out] = ends_of(tendon, k);
        add_contact(tendon.first_contact + k, in, out);
      }
    }
    for (std::size_t i = 0; i < net_.blocks.size(); ++i) add_block(i);
    for (std::size_t i = 0; i < net_.segments.size(); ++i) add_segment(i);
    const Box& hand = places_.hand;
    out_.hand = {left_ + hand.left, palm_ + hand.top, left_ + hand.right, palm_ + hand.bottom};
    out_.height = palm_ + places_.bottom + margin;
    add_carriage();
    if (frame_.with_legend) add_legend();
    return std::move(out_);
  }

 private:
  Point moved(Point place) const { return {left_ + place.x, palm_ + place.y}; }

  Point at(std::size_t port) const {
    const Point place = moved(places_.ports[port]);
    if (all_.ports[port].role != PortRole::strand) return place;
    return {place.x, fingertips_[all_.of(port).index]};
  }

  // Title and subtitle; returns where the drawing may begin.
  double add_heading() {
    const double title = add_lines(frame_.title, 10, {{}, "", 16, Weight::bold});
    return add_lines(frame_.subtitle, title, {{}, "", small_size, Weight::normal}) + 6;
  }

  double add_lines(const std::string& text, double top, DrawnText style) {
    const double width = out_.width - 2 * margin;
    const bool bold = style.weight == Weight::bold;
    for (const std::string& piece : wrap(text, style.size, bold, width)) {
      style.text = piece;
      style.box = {margin, top, margin + std::min(width, text_width(piece, style.size, bold)),
                   top + style.size + 4};
      out_.texts.push_back(style);
      top = style.box.bottom;
    }
    return top;
  }

  void add_finger(int number, const FingerRow& row) {
    const auto f = static_cast<std::size_t>(number - 1);
    const FingerHeights& heights = row.fingers[f];
    const bool anchored = is_anchored(net_, number);
    fingertips_.push_back(anchored ? heights.top + anchor_depth : heights.centre);
    const double middle = left_ + places_.fingers[f];
    const double half = pitch / 2 + flesh;
    const bool held = frame_.held.holds(number);
    const Box object{middle - object_size / 2, heights.top - 1 - object_size,
                     middle + object_size / 2, heights.top - 1};
    out_.fingers.push_back(
        {{middle - half, heights.top, middle + half, row.base}, held, held ? object : Box{}});
    // Over the fingertip, or over what holds it.
    double bottom = held ? object.top - 1 : heights.top - 3;
    const auto add = [&](const std::string& text, Weight weight) {
      const double reach = text_width(text, small_size, weight == Weight::bold) / 2;
      const Box box{middle - reach, bottom - line_height, middle + reach, bottom};
      out_.texts.push_back({box, text, small_size, weight, Align::middle});
      bottom -= line_height;
    };
    if (held) add("held", Weight::bold);
    add(fmt::format("finger {}", number), Weight::normal);
  }

  // Between segments `before` and `after`.
  void add_contact(std::size_t i, std::size_t before, std::size_t after) {
    const Contact& contact = net_.contacts[i];
    const std::size_t in = all_.segments[before].port[1];
    const std::size_t out = all_.segments[after].port[0];
    DrawnContact drawn;
    drawn.kind = contact.kind;
    drawn.place = contact.place;
    const Point from = at(in);
    const Point to = at(out);
    drawn.centre = {(from.x + to.x) / 2, from.y};
    drawn.apex = all_.faces_down(in) ? -1 : 1;
    drawn.forward = from.x < to.x;
    if (contact.place == ContactPlace::sheath) {
      drawn.length = sheath_length;
      drawn.forward = all_.ports[in].role == PortRole::hand_side;
      // On the side of the label below.
      const LabelPlace& label = places_.labels[drawn.forward ? after : before];
      drawn.arrow_side = label.align == Align::end ? -1 : 1;
    } else if (contact.kind == ContactKind::bar) {
      drawn.centre = at(tail_of(contact.block));
    } else {
      drawn.radius = std::abs(to.x - from.x) / 2;
    }
    out_.contacts.push_back(drawn);
  }

  std::size_t tail_of(std::size_t block) const {
    const std::vector<std::size_t>& ports = all_.fittings[all_.blocks[block]].ports;
    return *std::ranges::find_if(ports,
                                 [&](std::size_t port) { return is_tail(all_.ports[port].role); });
  }

  void add_block(std::size_t i) {
    const core::Block& block = net_.blocks[i];
    const Fitting& fitting = all_.fittings[all_.blocks[i]];
    DrawnBlock drawn;
    drawn.is_bar = block.is_bar;
    drawn.apex = fitting.inverted ? -1 : 1;
    drawn.sheave = tip_radius - thickest / 2 - 1;
    for (const std::size_t port : fitting.ports) {
      const FittingPort& place = all_.ports[port];
      if (place.role == PortRole::turn) {
        if (port < place.twin) drawn.axles.push_back(centre(port));
      } else {
        (is_tail(place.role) ? drawn.tails : drawn.eyes).push_back(at(port));
      }
    }
    const Point tail = at(tail_of(i));
    const double x = tail.x - all_.ports[tail_of(i)].offset;
    drawn.beam = block.is_bar ? tail.y : tail.y - drawn.apex * (tail_eye - beam_depth);
    const double half = block.is_bar ? bar_half : beam_half;
    const double beside = drawn.beam + drawn.apex * (half + 2 + name_height / 2);
    const auto [first, last] = tails_of(all_, all_.blocks[i]);
    const double before = x + first - name_left;
    drawn.motion = {before - motion_width, beside - motion_length / 2, before,
                    beside + motion_length / 2};
    out_.blocks.push_back(drawn);
    const double left = x + last + name_left;
    const Box name{left, beside - name_height / 2, left + name_width(block),
                   beside + name_height / 2};
    out_.texts.push_back({name, block_title(block), small_size, Weight::bold, Align::start});
  }

  // Centre of a turn's half circle.
  Point centre(std::size_t port) const {
    const Point place = at(port);
    return {(place.x + at(all_.ports[port].twin).x) / 2, place.y};
  }

  void add_segment(std::size_t i) {
    const Segment& segment = net_.segments[i];
    DrawnSegment drawn;
    drawn.name = segment_name(segment);
    drawn.tendon = all_.segments[i].tendon;
    drawn.path = path(i);
    for (const std::size_t side : {0U, 1U}) add_end(i, side, drawn);
    const bool strand = segment.kind == SegmentKind::strand;
    label(strand ? strand_label(i)
                 : LabelPlace{moved(places_.labels[i].top), places_.labels[i].align},
          drawn);
    out_.segments.push_back(std::move(drawn));
  }

  Path path(std::size_t segment) const {
    Path path = inward(segment, 0);
    std::ranges::reverse(path);
    for (const LevelPiece& piece : places_.pieces[segment]) {
      const double radius = std::min(piece.rounding, std::abs(piece.to - piece.from) / 2);
      if (radius == 0) continue;
      append(path, {{moved({piece.from, piece.y}), radius}, {moved({piece.to, piece.y}), radius}});
    }
    append(path, inward(segment, 1));
    return path;
  }

  // Path from a segment's line to its end, or to the middle of the contact there.
  Path inward(std::size_t segment, std::size_t side) const {
    const std::size_t port = all_.segments[segment].port[side];
    if (port == nowhere) return {{moved(places_.loose[segment]), 0}};
    const Point place = at(port);
    const PortRole role = all_.ports[port].role;
    const bool has_turn = all_.ports[port].twin != nowhere;
    if (role != PortRole::turn && !(role == PortRole::strand && has_turn)) return {{place, 0}};
    const double middle = centre(port).x;
    const double radius = std::abs(middle - place.x);
    const double apex = place.y + (all_.faces_down(port) ? -radius : radius);
    return {{{place.x, apex}, radius}, {{middle, apex}, 0}};
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
      const bool extensor = net_.segments[segment].extensor;
      out_.ends.push_back({extensor ? EndHold::extensor : EndHold::anchored, at, -1});
    } else if (is_tail(role) || role == PortRole::becket) {
      out_.ends.push_back({EndHold::block, at, 1});
    }
  }

  LabelPlace strand_label(std::size_t segment) const {
    const Segment& strand = net_.segments[segment];
    const auto f = static_cast<std::size_t>(strand.finger - 1);
    const double upper = palm_ - 6 - label_height - label_step;
    const double middle = left_ + places_.fingers[f];
    bool left = strand.number % 2 == 1;
    if (is_anchored(net_, strand.finger)) {
      const double offset = tied_offset(segment);
      if (offset == 0) return {{middle, upper}, Align::start};
      left = offset < 0;
    }
    if (left) return {{middle - tip_radius, upper}, Align::start};
    return {{middle + tip_radius, upper + label_step}, Align::end};
  }

  // Offset of the fingertip's port to which a strand is tied.
  double tied_offset(std::size_t segment) const {
    const std::array<std::size_t, 2>& ports = all_.segments[segment].port;
    const bool first = ports[0] != nowhere && all_.ports[ports[0]].role == PortRole::strand;
    return all_.ports[ports[first ? 0 : 1]].offset;
  }

  static void label(const LabelPlace& place, DrawnSegment& drawn) {
    constexpr double under = 20;  // half the room under a bend
    const auto [x, top] = place.top;
    drawn.align = place.align;
    drawn.label = {x + label_gap, top, x + label_gap + label_width, top + label_height};
    if (place.align == Align::end) {
      drawn.label.left = x - label_gap - label_width;
      drawn.label.right = drawn.label.left + label_width;
    } else if (place.align == Align::middle) {
      drawn.label.left = x - under;
      drawn.label.right = x + under;
    }
  }

  // Below what hangs on it, with the motor's arrow and text.
  void add_carriage() {
    constexpr double arrow = 34;
    const double bottom = palm_ + places_.bottom;
    for (const Hanging& run : hanging_runs()) {
      const Box box{run.left - run.room_left, palm_ + places_.carriage_top,
                    run.right + run.room_right, bottom};
      const double step = (run.right - run.left) / (static_cast<double>(run.motors.size()) + 1);
      double x = run.left;
      for (const int motor : run.motors) {
        x += step;
        out_.carriages.push_back({motor, box, {x - 6, bottom + 2, x + 6, bottom + 2 + arrow}, {}});
      }
    }
    if (out_.carriages.empty()) return;
    out_.height = out_.carriages.front().arrow.bottom + margin;
    if (out_.carriages.size() == 1) {
      out_.carriages.front().text = text_beside(out_.carriages.front());
      return;
    }
    for (DrawnCarriage& carriage : out_.carriages) {
      carriage.text = text_below(carriage, out_.height - margin + 2);
      out_.height = carriage.text.box.bottom + margin;
    }
  }

  // Tendons side by side on one carriage, or on several whose tendons cross, and the room beside
  // them.
  struct Hanging {
    std::set<int> motors;
    double left = 0;
    double right = 0;
    double room_left = 22;
    double room_right = 22;
  };

  std::vector<Hanging> hanging_runs() const {
    std::vector<Hanging> all;
    for (std::size_t i = 0; i < net_.segments.size(); ++i) {
      if (net_.segments[i].kind != SegmentKind::motor_side) continue;
      Hanging one{{net_.segments[i].carriage}, out_.width, 0};
      for (const std::size_t port : all_.segments[i].port) {
        if (port == nowhere) continue;
        one.left = std::min(one.left, at(port).x);
        one.right = std::max(one.right, at(port).x);
      }
      all.push_back(one);
    }
    std::ranges::sort(all, {}, &Hanging::left);
    std::vector<Hanging> runs;
    for (const Hanging& one : all) {
      if (!runs.empty() && (runs.back().motors == one.motors || one.left <= runs.back().right)) {
        runs.back().motors.insert(one.motors.begin(), one.motors.end());
        runs.back().right = std::max(runs.back().right, one.right);
        continue;
      }
      runs.push_back(one);
    }
    constexpr double gap = 2;
    for (std::size_t i = 1; i < runs.size(); ++i) {
      const double room = (runs[i].left - runs[i - 1].right) / 2 - gap;
      runs[i - 1].room_right = std::min(runs[i - 1].room_right, room);
      runs[i].room_left = std::min(runs[i].room_left, room);
    }
    return runs;
  }

  static double motor_text_width(const char* text) { return text_width(text, small_size, false); }

  DrawnText text_beside(const DrawnCarriage& carriage) const {
    constexpr double aside = 5;
    const double top = (carriage.arrow.top + carriage.arrow.bottom - line_height) / 2;
    const double width = motor_text_width("motor 1.00");
    DrawnText text{{}, "", small_size, Weight::normal, Align::start};
    const double right = carriage.arrow.right + aside;
    text.box = {right, top, right + width, top + line_height};
    if (text.box.right > out_.width - margin / 2) {
      const double left = carriage.arrow.left - aside;
      text.box = {left - width, top, left, top + line_height};
      text.align = Align::end;
    }
    return text;
  }

  // One below the other, so that the texts of carriages that stand close do not meet.
  DrawnText text_below(const DrawnCarriage& carriage, double top) const {
    const double half = motor_text_width("motor 1, travel -0.555: 1.00") / 2;
    const double middle = std::clamp((carriage.arrow.left + carriage.arrow.right) / 2,
                                     margin / 2 + half, out_.width - margin / 2 - half);
    DrawnText text{{}, "", small_size, Weight::normal, Align::middle};
    text.box = {middle - half, top, middle + half, top + line_height};
    return text;
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
  const Places& places_;
  const Fittings& all_;
  double left_ = 0;                 // x of the leftmost part
  double palm_ = 0;                 // y
  std::vector<double> fingertips_;  // y of the turns there, or of what is tied
  SchematicLayout out_;
};

}  // namespace

Places::Places(Fittings placed)
    : fittings(std::move(placed)),
      ports(fittings.ports.size()),
      pieces(fittings.segments.size()),
      loose(fittings.segments.size()),
      labels(fittings.segments.size()) {}

Places places(const Network& network) {
  Fittings parts = fittings(network);
  return has_floating_parts(network) ? places_in_levels(network, std::move(parts))
                                     : places_in_rows(network, std::move(parts));
}

SchematicLayout layout(const Network& network, const SchematicFrame& frame, const Places& places) {
  return Layouter(network, frame, places).run();
}

SchematicLayout layout(const Network& network, const SchematicFrame& frame) {
  return layout(network, frame, places(network));
}

}  // namespace reeve::drawing
