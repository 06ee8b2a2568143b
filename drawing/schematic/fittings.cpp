#include "drawing/schematic/fittings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drawing/schematic/schematic_measures.hpp"
#include "drawing/shapes.hpp"

namespace reeve::drawing {
namespace {

using namespace measures;

class Assembly {
 public:
  explicit Assembly(const Network& network) : net_(network) {}

  Fittings assemble() {
    out_.segments.resize(net_.segments.size());
    out_.turns.assign(net_.contacts.size(), {nowhere, nowhere});
    for (int f = 0; f < net_.fingers; ++f) {
      add_fitting(FittingKind::finger, static_cast<std::size_t>(f));
    }
    for (std::size_t b = 0; b < net_.blocks.size(); ++b) {
      out_.blocks.push_back(add_fitting(FittingKind::block, b));
    }
    for (std::size_t t = 0; t < net_.tendons.size(); ++t) add_tendon(t);
    for (std::size_t i = 0; i < out_.fittings.size(); ++i) {
      std::vector<std::size_t>& ports = out_.fittings[i].ports;
      std::stable_partition(ports.begin(), ports.end(),
                            [&](std::size_t port) { return !is_tail(out_.ports[port].role); });
      place_ports(net_, i, out_);
    }
    return std::move(out_);
  }

 private:
  std::size_t add_fitting(FittingKind kind, std::size_t index) {
    Fitting fitting;
    fitting.kind = kind;
    fitting.index = index;
    out_.fittings.push_back(fitting);
    return out_.fittings.size() - 1;
  }

  std::size_t add_port(std::size_t fitting, PortRole role) {
    out_.ports.push_back({fitting, role});
    out_.fittings[fitting].ports.push_back(out_.ports.size() - 1);
    return out_.ports.size() - 1;
  }

  void add_tendon(std::size_t t) {
    const TendonSpan& tendon = net_.tendons[t];
    const std::size_t last = tendon.first_segment + tendon.segments - 1;
    for (std::size_t i = tendon.first_segment; i <= last; ++i) {
      out_.segments[i].tendon = t;
      const bool motor_side = net_.segments[i].kind == SegmentKind::motor_side;
      out_.segments[i].loose = motor_side ? LooseEnd::tied : LooseEnd::fixed;
    }
    if (!tendon.closed) add_end(tendon.left, tendon.first_segment, 0);
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const auto [left, right] = ends_of(tendon, k);
      add_contact(tendon.first_contact + k, left, right);
    }
    if (!tendon.closed) add_end(tendon.right, last, 1);
    if (out_.segments[last].port == std::array{nowhere, nowhere}) {
      out_.segments[last].port[1] = add_port(add_fitting(FittingKind::clamp, 0), PortRole::clamp);
    }
  }

  void add_end(const TendonEnd& end, std::size_t segment, std::size_t side) {
    if (end.tie != EndTie::none) {
      const bool bar = net_.blocks[end.block].is_bar;
      const PortRole role = end.tie == EndTie::becket ? PortRole::becket
                            : bar                     ? PortRole::pivot
                                                      : PortRole::tail;
      out_.segments[segment].port[side] = add_port(out_.blocks[end.block], role);
      return;
    }
    const Segment& strand = net_.segments[segment];
    if (strand.kind != SegmentKind::strand || !is_anchored(net_, strand.finger)) return;
    const auto finger = static_cast<std::size_t>(strand.finger - 1);
    // `1x-F`: either end is the tip.
    const auto is_tip = [&](std::size_t port) {
      return port != nowhere && out_.ports[port].fitting == finger;
    };
    if (std::ranges::any_of(out_.segments[segment].port, is_tip)) return;
    out_.segments[segment].port[side] = add_port(finger, PortRole::strand);
  }

  void add_contact(std::size_t contact, std::size_t left, std::size_t right) {
    const Contact& at = net_.contacts[contact];
    std::size_t fitting = nowhere;
    PortRole in = PortRole::turn;
    PortRole out = PortRole::turn;
    switch (at.place) {
      case ContactPlace::tip:
        fitting = static_cast<std::size_t>(at.finger - 1);
        in = out = PortRole::strand;
        break;
      case ContactPlace::hand_join:
        fitting = add_fitting(FittingKind::join, contact);
        break;
      case ContactPlace::carriage:
        fitting = add_fitting(FittingKind::pulley, contact);
        break;
      case ContactPlace::sheath: {
        fitting = add_fitting(FittingKind::sheath, contact);
        const bool downward = net_.segments[right].kind == SegmentKind::motor_side;
        in = downward ? PortRole::hand_side : PortRole::motor_side;
        out = downward ? PortRole::motor_side : PortRole::hand_side;
        break;
      }
      case ContactPlace::block:
        fitting = out_.blocks[at.block];
        if (at.kind == ContactKind::bar) in = out = PortRole::arm;
        break;
    }
    const std::size_t first = add_port(fitting, in);
    const std::size_t second = add_port(fitting, out);
    out_.ports[first].twin = second;
    out_.ports[second].twin = first;
    out_.segments[left].port[1] = first;
    out_.segments[right].port[0] = second;
    out_.turns[contact] = {first, second};
  }

  const Network& net_;
  Fittings out_;
};

// Whole pixels, so that lines meet their ports exactly; to scale up to 9 : 1.
std::array<double, 2> arm_lengths(const ArmRatio& arms) {
  constexpr int least_arm = 26;
  constexpr int least_bar = 104;  // distance between the middles of two fingers
  constexpr int longest_bar = 264;
  const int a = arms.left;
  const int b = arms.right;
  const int sum = a + b;
  const int least = std::min(a, b);
  const int unit = std::max((least_arm + least - 1) / least, (least_bar + sum - 1) / sum);
  if (unit * sum <= longest_bar) return {1.0 * unit * b, 1.0 * unit * a};
  const int longer = longest_bar - least_arm;
  const int shorter = least == a && least == b ? longer : least_arm;
  return a < b ? std::array<double, 2>{1.0 * longer, 1.0 * shorter}
               : std::array<double, 2>{1.0 * shorter, 1.0 * longer};
}

// Uses the pitch of two strands of a finger, so that a sheave and the joins beside it line up.
void spread(const std::vector<std::size_t>& row, Fittings& all) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    all.ports[row[i]].offset =
        pitch * (static_cast<double>(i) - static_cast<double>(row.size() - 1) / 2);
  }
}

}  // namespace

bool Fittings::faces_down(std::size_t port) const {
  const Fitting& fitting = of(port);
  switch (ports[port].role) {
    case PortRole::strand:
    case PortRole::motor_side:
    case PortRole::clamp:
      return true;
    case PortRole::tail:
    case PortRole::pivot:
      return !fitting.inverted;
    case PortRole::turn:
    case PortRole::arm:
    case PortRole::becket:
      return fitting.inverted;
    case PortRole::hand_side:
    case PortRole::bend:
      return false;
  }
  return false;
}

bool is_anchored(const Network& network, int finger) {
  return std::ranges::none_of(network.contacts, [&](const Contact& c) {
    return c.place == ContactPlace::tip && c.finger == finger;
  });
}

bool has_floating_parts(const Network& network) {
  if (!network.blocks.empty()) return true;
  for (int finger = 1; finger <= network.fingers; ++finger) {
    if (is_anchored(network, finger)) return true;
  }
  return false;
}

Tails tails_of(const Fittings& all, std::size_t fitting) {
  Tails found;
  for (const std::size_t port : all.fittings[fitting].ports) {
    if (!is_tail(all.ports[port].role)) continue;
    found.first = std::min(found.first, all.ports[port].offset);
    found.last = std::max(found.last, all.ports[port].offset);
  }
  return found;
}

Fittings fittings(const Network& network) { return Assembly(network).assemble(); }

void place_ports(const Network& network, std::size_t fitting, Fittings& all) {
  const Fitting& placed = all.fittings[fitting];
  std::vector<std::size_t> tails;
  std::vector<std::size_t> others;
  for (const std::size_t port : placed.ports) {
    (is_tail(all.ports[port].role) ? tails : others).push_back(port);
  }
  if (placed.kind == FittingKind::sheath) return;
  spread(tails, all);
  spread(others, all);
  if (placed.kind == FittingKind::block && network.blocks[placed.index].is_bar) {
    const auto [left, right] = arm_lengths(network.blocks[placed.index].arms);
    const bool mirrored = others.front() > others.back();
    all.ports[others.front()].offset = mirrored ? -right : -left;
    all.ports[others.back()].offset = mirrored ? left : right;
  }
}

std::string block_title(const core::Block& block) {
  const ArmRatio& arms = block.arms;
  if (arms.left == arms.right) return block_name(block);
  return fmt::format("{} {}:{}", block_name(block), arms.left, arms.right);
}

double name_width(const core::Block& block) {
  return text_width(block_title(block), small_size, true);
}

}  // namespace reeve::drawing
