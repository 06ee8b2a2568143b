#include <algorithm>

#include "drawing/schematic/columns.hpp"
#include "drawing/schematic/schematic_measures.hpp"

namespace reeve::drawing {
namespace {

using namespace measures;

constexpr double body_margin = 12;  // beside the outermost lines of a fitting
constexpr double apart = 18;        // least distance of parallel lines

class Cutting {
 public:
  Cutting(const Network& network, const Fittings& all, const Lanes& lanes, const Heights& heights,
          const Ranks& ranks)
      : net_(network), all_(all), lanes_(lanes), heights_(heights), ranks_(ranks) {}

  std::vector<Strip> cut() {
    for (std::size_t i = 0; i < all_.fittings.size(); ++i) add_body(i);
    for (const LaneStretch& stretch : lanes_.stretches) add_lines(stretch);
    for (std::size_t i = 0; i < all_.segments.size(); ++i) add_straight(i);
    for (std::size_t i = 0; i < all_.segments.size(); ++i) add_label(i);
    return std::move(strips_);
  }

 private:
  void add(std::size_t port, double left, double right, double top, double bottom,
           std::size_t segment = nowhere, bool rises = false) {
    const auto [fitting, offset] = column_of(all_, port);
    strips_.push_back(
        {fitting, ranks_[port], offset + left, offset + right, top, bottom, segment, rises});
  }

  void add_line(std::size_t port, double from, double to, std::size_t segment, bool rises) {
    add(port, -apart / 2, apart / 2, std::min(from, to), std::max(from, to), segment, rises);
  }

  // A fitting's own outline, over its level.
  void add_body(std::size_t i) {
    const Fitting& fitting = all_.fittings[i];
    if (fitting.ports.empty() || fitting.kind == FittingKind::bend) return;
    if (fitting.kind == FittingKind::finger) {
      constexpr double half = pitch / 2 + flesh + 8;
      strips_.push_back(
          {i, ranks_[fitting.ports.front()], -half, half, -infinity, heights_.level[0]});
      return;
    }
    double left = 0;
    double right = 0;
    for (const std::size_t port : fitting.ports) {
      left = std::min(left, all_.ports[port].offset);
      right = std::max(right, all_.ports[port].offset);
    }
    if (fitting.kind == FittingKind::sheath) {
      const double middle = heights_.level[fitting.level];
      add_box(i, -sleeve - 3, sleeve + 14, middle - sheath_length / 2, middle + sheath_length / 2);
      return;
    }
    if (fitting.kind == FittingKind::block) {
      const auto [first, last] = tails_of(all_, i);
      left = std::min(left, first - name_left - motion_width + 8);
      right = std::max(right, last + name_left + name_width(net_.blocks[fitting.index]) - 8);
    }
    const std::vector<ChannelHeights>& channel = heights_.channel;
    const bool lowest = fitting.level == channel.size();
    add_box(i, left - body_margin, right + body_margin, channel[fitting.level - 1].bottom,
            lowest ? heights_.bottom : channel[fitting.level].top);
  }

  void add_box(std::size_t i, double left, double right, double top, double bottom) {
    const Fitting& fitting = all_.fittings[i];
    const std::size_t port = fitting.ports.front();
    const auto [base, offset] = column_of(all_, port);
    const double middle = offset - all_.ports[port].offset;
    strips_.push_back({base, ranks_[port], middle + left, middle + right, top, bottom});
  }

  void add_lines(const LaneStretch& stretch) {
    const double y = height(heights_, stretch);
    for (const std::size_t end : {0U, 1U}) {
      const bool rises = stretch.rises[end];
      const std::size_t port = stretch.port[end];
      const bool at_bend = all_.ports[port].role == PortRole::bend;
      const double to = at_bend ? height_at_bend(stretch, port) : height(all_, heights_, port);
      add_line(port, to, y + (rises ? bend : -bend), stretch.segment, rises);
    }
  }

  // Height of the line's other stretch.
  double height_at_bend(const LaneStretch& stretch, std::size_t port) const {
    for (const LaneStretch& other : lanes_.stretches) {
      if (&other == &stretch || other.segment != stretch.segment) continue;
      if (other.port[0] == port || other.port[1] == port) return height(heights_, other);
    }
    return height(heights_, stretch);
  }

  void add_straight(std::size_t segment) {
    const SegmentEnds& ends = all_.segments[segment];
    for (const std::size_t side : {0U, 1U}) {
      const std::size_t port = ends.port[side];
      const std::size_t other = ends.port[1 - side];
      if (port == nowhere) continue;
      const double from = height(all_, heights_, port);
      if (other == nowhere) {
        const double to = loose_end(all_, heights_, port, ends.loose);
        add_line(port, from, to, segment, false);
        const double reach = (to > from ? 1 : -1) * (fixation_depth + 2);
        const double half = fixation_width / 2 + 4;
        add(port, -half, half, std::min(to, to + reach), std::max(to, to + reach), segment, false);
      } else if (all_.ports[port].role == PortRole::hand_side && all_.of(port).carrier == other) {
        add_line(port, from, height(all_, heights_, other), segment, false);
      }
    }
  }

  void add_label(std::size_t segment) {
    if (net_.segments[segment].kind == SegmentKind::strand) return;
    const std::size_t port = labelled_port(net_, all_, segment);
    if (port == nowhere) return;
    const double top = label_top(all_, heights_, port);
    // Just clear of a line at the pitch of two strands.
    add(port, 0, pitch - apart / 2, top, top + label_height);
  }

  const Network& net_;
  const Fittings& all_;
  const Lanes& lanes_;
  const Heights& heights_;
  const Ranks& ranks_;
  std::vector<Strip> strips_;
};

}  // namespace

ColumnOf column_of(const Fittings& all, std::size_t port) {
  double offset = all.ports[port].offset;
  while (all.of(port).carrier != nowhere) {
    port = all.of(port).carrier;
    offset += all.ports[port].offset;
  }
  return {all.ports[port].fitting, offset};
}

std::vector<Strip> strips(const Network& network, const Fittings& all, const Lanes& lanes,
                          const Heights& heights, const Ranks& ranks) {
  return Cutting(network, all, lanes, heights, ranks).cut();
}

}  // namespace reeve::drawing
