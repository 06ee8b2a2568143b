#include <algorithm>

#include "drawing/schematic/levels.hpp"

namespace reeve::drawing {
namespace {

std::size_t level_of(const Fittings& all, std::size_t port) { return all.of(port).level; }

void add_stretches(const Fittings& all, std::size_t segment, std::vector<LaneStretch>& found) {
  const SegmentEnds& ends = all.segments[segment];
  const auto [one, other] = ends.port;
  if (one == nowhere || other == nowhere) return;
  const auto hangs_on = [&](std::size_t lower, std::size_t upper) {
    return all.ports[lower].role == PortRole::hand_side && all.of(lower).carrier == upper;
  };
  if (hangs_on(one, other) || hangs_on(other, one)) return;
  const bool one_down = all.faces_down(one);
  const bool other_down = all.faces_down(other);
  if (one_down == other_down) {
    const std::size_t low = std::min(level_of(all, one), level_of(all, other));
    const std::size_t high = std::max(level_of(all, one), level_of(all, other));
    found.push_back({segment, one_down ? high : low - 1, 0, {one, other}, {one_down, one_down}});
    return;
  }
  const std::size_t upper = one_down ? one : other;
  const std::size_t lower = one_down ? other : one;
  if (ends.via == nowhere) {
    found.push_back({segment, level_of(all, lower) - 1, 0, {upper, lower}, {true, false}});
    return;
  }
  found.push_back({segment, level_of(all, upper), 0, {upper, ends.via}, {true, true}});
  found.push_back({segment, level_of(all, lower) - 1, 0, {ends.via, lower}, {false, false}});
}

class ChannelLanes {
 public:
  ChannelLanes(std::vector<LaneStretch*> stretches, const Ranks& ranks)
      : order_(std::move(stretches)), ranks_(ranks) {}

  // Returns how many lanes they take.
  std::size_t assign() {
    for (bool improved = true; improved;) {
      improved = false;
      for (std::size_t i = 1; i < order_.size(); ++i) {
        if (crossings(*order_[i], *order_[i - 1]) >= crossings(*order_[i - 1], *order_[i])) {
          continue;
        }
        std::swap(order_[i], order_[i - 1]);
        improved = true;
      }
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      for (std::size_t above = 0; above < i; ++above) {
        if (!overlap(*order_[above], *order_[i])) continue;
        order_[i]->lane = std::max(order_[i]->lane, order_[above]->lane + 1);
      }
      count = std::max(count, order_[i]->lane + 1);
    }
    return count;
  }

 private:
  double left(const LaneStretch& a) const { return std::min(ranks_[a.port[0]], ranks_[a.port[1]]); }
  double right(const LaneStretch& a) const {
    return std::max(ranks_[a.port[0]], ranks_[a.port[1]]);
  }
  bool overlap(const LaneStretch& a, const LaneStretch& b) const {
    return left(a) <= right(b) && left(b) <= right(a);
  }

  // … of two stretches, the upper above the lower.
  int crossings(const LaneStretch& upper, const LaneStretch& lower) const {
    int count = 0;
    for (const std::size_t end : {0U, 1U}) {
      const double up = ranks_[upper.port[end]];
      const double down = ranks_[lower.port[end]];
      if (!upper.rises[end] && up > left(lower) && up < right(lower)) ++count;
      if (lower.rises[end] && down > left(upper) && down < right(upper)) ++count;
    }
    return count;
  }

  std::vector<LaneStretch*> order_;
  const Ranks& ranks_;
};

}  // namespace

Lanes lanes(const Fittings& all, const Ranks& ranks) {
  Lanes found;
  for (std::size_t i = 0; i < all.segments.size(); ++i) add_stretches(all, i, found.stretches);
  for (std::size_t channel = 0; channel < all.sheath_level + 2; ++channel) {
    std::vector<LaneStretch*> here;
    for (LaneStretch& stretch : found.stretches) {
      if (stretch.channel == channel) here.push_back(&stretch);
    }
    found.of_channel.push_back(ChannelLanes(std::move(here), ranks).assign());
  }
  return found;
}

}  // namespace reeve::drawing
