#include <algorithm>

#include "drawing/schematic/levels.hpp"
#include "drawing/schematic/schematic_measures.hpp"

namespace reeve::drawing {
namespace {

using namespace measures;

constexpr double below_level = 6;  // distance to the channel
constexpr double lane_room = 12;   // above the topmost lane and below the lowest
constexpr double label_room = 4;   // above and below a label
constexpr double stub = label_height + 2 * label_room + 2;  // length of a fixed end with a label
constexpr double short_stub = 12;                           // … without

struct FittingExtent {
  double above = 0;
  double below = 0;
};

FittingExtent extent(const Network& network, const Fitting& fitting) {
  constexpr double wheel = tip_radius - thickest / 2;
  switch (fitting.kind) {
    case FittingKind::block: {
      const bool bar = network.blocks[fitting.index].is_bar;
      const FittingExtent upright =
          bar ? FittingExtent{turning_arrow + 6, bar_half + name_height + 4}
              : FittingExtent{wheel + 2, tail_eye + 9};
      return fitting.inverted ? FittingExtent{upright.below, upright.above} : upright;
    }
    case FittingKind::join:
    case FittingKind::pulley: {
      const FittingExtent upright{wheel + 2, tip_radius + sleeve + 2};
      return fitting.inverted ? FittingExtent{upright.below, upright.above} : upright;
    }
    case FittingKind::sheath:
      return {sheath_length / 2, sheath_length / 2};
    case FittingKind::clamp:
      return {fixation_depth + 2, 2};
    case FittingKind::finger:
    case FittingKind::bend:
      return {};
  }
  return {};
}

// The bands of a channel, for labels and fixed ends.
struct HeightBands {
  double upper = 0;
  double lower = 0;
};

class Measuring {
 public:
  Measuring(const Network& network, const Fittings& all, const Lanes& lanes)
      : net_(network), all_(all), lanes_(lanes), bands_(lanes.of_channel.size()) {}

  Heights measure() {
    for (std::size_t i = 0; i < all_.segments.size(); ++i) need_room(i);
    out_.level.push_back(0);
    double y = 0;
    for (std::size_t channel = 0; channel < all_.sheath_level; ++channel) {
      y = add_channel(channel, y, channel == 0 ? 0 : below_level);
      if (channel + 1 == all_.sheath_level) break;
      y = add_level(channel + 1, y);
    }
    constexpr double least = 34;
    out_.hand_bottom = std::max(y + 10, least);
    out_.bottom = out_.hand_bottom;
    out_.channel.back().bottom = out_.hand_bottom - 6;
    if (has_carriage()) add_carriage();
    return std::move(out_);
  }

 private:
  bool has_carriage() const {
    return std::ranges::any_of(all_.fittings,
                               [](const Fitting& f) { return f.kind == FittingKind::sheath; });
  }

  void need_room(std::size_t segment) {
    const SegmentEnds& ends = all_.segments[segment];
    const bool hand = net_.segments[segment].kind == SegmentKind::hand;
    const std::size_t labelled = hand ? labelled_port(net_, all_, segment) : nowhere;
    if (labelled != nowhere) {
      need(labelled, label_height + 2 * label_room);
    }
    for (const std::size_t side : {0U, 1U}) {
      const std::size_t port = ends.port[1 - side];
      if (ends.port[side] != nowhere || port == nowhere) continue;
      if (ends.loose == LooseEnd::tied) continue;
      need(port, hand ? stub + fixation_depth + 4 : short_stub + fixation_depth + 4);
    }
  }

  void need(std::size_t port, double room) {
    const bool down = all_.faces_down(port);
    HeightBands& bands = bands_[all_.of(port).level - (down ? 0 : 1)];
    double& band = down ? bands.upper : bands.lower;
    band = std::max(band, room);
  }

  double add_channel(std::size_t channel, double top, double before) {
    ChannelHeights at;
    const std::size_t count = lanes_.of_channel[channel];
    at.top = top + before;
    at.lanes = at.top + bands_[channel].upper + lane_room;
    at.below = at.top + bands_[channel].upper;
    if (count > 0) at.below = at.lanes + lane_pitch * static_cast<double>(count - 1) + lane_room;
    at.bottom = at.below + bands_[channel].lower;
    out_.channel.push_back(at);
    return at.bottom;
  }

  double add_level(std::size_t level, double top) {
    FittingExtent most;
    for (const Fitting& fitting : all_.fittings) {
      if (fitting.level != level) continue;
      const FittingExtent one = extent(net_, fitting);
      most = {std::max(most.above, one.above), std::max(most.below, one.below)};
    }
    out_.level.push_back(top + most.above);
    return top + most.above + most.below;
  }

  void add_carriage() {
    out_.level.push_back(out_.hand_bottom - 6 + sheath_length / 2);
    const double labels = out_.level.back() + sheath_length / 2 + 8;
    out_.carriage_top = labels + label_height + 8;
    out_.tied = out_.carriage_top + 12;
    const bool any_tied = std::ranges::any_of(all_.segments, [](const SegmentEnds& s) {
      return s.loose == LooseEnd::tied && (s.port[0] == nowhere || s.port[1] == nowhere);
    });
    const std::size_t channel = all_.sheath_level;
    bands_[channel].upper =
        (any_tied ? out_.tied + knot_size / 2 + 2 : out_.carriage_top + 2) - labels;
    double y = add_channel(channel, labels, 0);
    if (lanes_.of_channel[channel] > 0) y = add_level(channel + 1, y);
    out_.bottom = y + 8;
  }

  const Network& net_;
  const Fittings& all_;
  const Lanes& lanes_;
  std::vector<HeightBands> bands_;
  Heights out_;
};

}  // namespace

std::size_t labelled_port(const Network& network, const Fittings& all, std::size_t segment) {
  const SegmentEnds& ends = all.segments[segment];
  const bool motor_side = network.segments[segment].kind == SegmentKind::motor_side;
  std::size_t best = nowhere;
  int most = 0;
  for (const std::size_t port : ends.port) {
    if (port == nowhere) continue;
    const PortRole role = all.ports[port].role;
    const bool of_sheath = role == PortRole::hand_side;
    const int fit = motor_side ? (role == PortRole::motor_side ? 2 : 1)
                               : 1 + (of_sheath ? 0 : 2) + (all.faces_down(port) ? 1 : 0);
    if (fit <= most) continue;
    most = fit;
    best = port;
  }
  return best;
}

Heights heights(const Network& network, const Fittings& all, const Lanes& lanes) {
  return Measuring(network, all, lanes).measure();
}

double height(const Fittings& all, const Heights& heights, std::size_t port) {
  const Fitting& fitting = all.of(port);
  const double middle = heights.level[fitting.level];
  const bool eye = all.ports[port].role == PortRole::tail;
  return eye ? middle + (fitting.inverted ? -1 : 1) * tail_eye : middle;
}

double height(const Heights& heights, const LaneStretch& stretch) {
  return heights.channel[stretch.channel].lanes + lane_pitch * static_cast<double>(stretch.lane);
}

double loose_end(const Fittings& all, const Heights& heights, std::size_t port, LooseEnd end) {
  if (end == LooseEnd::tied) return heights.tied;
  const bool down = all.faces_down(port);
  const bool strand = all.ports[port].role == PortRole::strand;
  const double length = strand ? short_stub : stub;
  const ChannelHeights& channel = heights.channel[all.of(port).level - (down ? 0 : 1)];
  return down ? channel.top + length : channel.bottom - length;
}

double label_top(const Fittings& all, const Heights& heights, std::size_t port) {
  const bool down = all.faces_down(port);
  const ChannelHeights& channel = heights.channel[all.of(port).level - (down ? 0 : 1)];
  if (all.ports[port].role == PortRole::motor_side) return channel.top;
  return down ? channel.top + label_room : channel.bottom - label_room - label_height;
}

}  // namespace reeve::drawing
