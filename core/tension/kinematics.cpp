#include "core/tension/kinematics.hpp"

#include <algorithm>
#include <cmath>

#include "core/tension/shared_kinematics.hpp"
#include "core/tension/split_kinematics.hpp"
#include "core/tension/tree_kinematics.hpp"

namespace reeve::core {
namespace {

// Slips are sums of a few tens of terms of order one: what is smaller than this is rounding.
constexpr double slip_tolerance = 1e-10;

struct TendonTally {
  bool is_driven = false;  // true if some carriage moves it
  bool has_motor_side = false;
  double motor_sides = 0;     // each counts with the travel of its carriage
  double closing_weight = 0;  // each finger counts with both of its strands
  double taut = 1;            // share of its travel behind its slack
};

double closing_weight(const Segment& segment, const Mechanics& mechanics) {
  return mechanics.closing[static_cast<std::size_t>(segment.finger - 1)];
}

TendonTally tally(const Network& network, const TendonSpan& tendon, const Mechanics& mechanics,
                  Grasp grasp) {
  TendonTally tally;
  double slack_mm = 0;
  for (std::size_t i = tendon.first_segment; i < tendon.first_segment + tendon.segments; ++i) {
    const Segment& segment = network.segments[i];
    if (segment.kind == SegmentKind::motor_side) {
      const double travel = end_travel(network, mechanics, grasp, i);
      tally.has_motor_side = true;
      if (!mechanics.slack_mm.empty()) slack_mm += mechanics.slack_mm[i];
      tally.is_driven |= travel != 0;
      tally.motor_sides += travel;
    }
    if (closes(segment, grasp)) tally.closing_weight += closing_weight(segment, mechanics);
  }
  if (std::abs(tally.motor_sides) < slip_tolerance) tally.motor_sides = 0;
  if (slack_mm > 0) {
    const double taken_in_mm = std::max(tally.motor_sides, 0.0) * mechanics.travel_mm;
    tally.taut = taken_in_mm > slack_mm ? 1 - slack_mm / taken_in_mm : 0;
  }
  return tally;
}

// Pulled, the carriage stretches its own segments; released, the hand's keep their strain. Behind a
// seized sheath a tendon has none there, and is what the carriage hangs on.
void impose_jam(const Network& network, const TendonSpan& tendon, const Mechanics& mechanics,
                const Grasp& grasp, Direction direction, Motion& motion) {
  const auto is_motor_side = [&](std::size_t i) {
    return network.segments[i].kind == SegmentKind::motor_side;
  };
  const std::size_t end = tendon.first_segment + tendon.segments;
  bool has_hand = false;
  for (std::size_t i = tendon.first_segment; i < end; ++i) has_hand |= !is_motor_side(i);
  const bool pull = direction == Direction::pull;
  for (std::size_t i = tendon.first_segment; i < end; ++i) {
    motion.imposed[i] = 0;
    if (pull) {
      motion.take_up[i] = is_motor_side(i) ? end_travel(network, mechanics, grasp, i) : 0;
    } else {
      motion.take_up[i] = has_hand && is_motor_side(i) ? 0 : mechanics.length[i];
    }
  }
}

// `closing_of` gives the dl of a closing finger's strand.
template <typename ClosingOf>
void impose_travel(const Network& network, const Mechanics& mechanics, const TendonSpan& tendon,
                   const Grasp& grasp, Direction direction, ClosingOf closing_of, Motion& motion) {
  const double sign = direction == Direction::pull ? 1 : -1;
  for (std::size_t i = tendon.first_segment; i < tendon.first_segment + tendon.segments; ++i) {
    const Segment& segment = network.segments[i];
    motion.imposed[i] = 0;
    if (segment.kind == SegmentKind::motor_side) {
      motion.imposed[i] = sign * end_travel(network, mechanics, grasp, i);
    } else if (closes(segment, grasp)) {
      const double dl = closing_of(segment);
      motion.imposed[i] = -sign * segment.way() * dl;
      motion.closing[static_cast<std::size_t>(segment.finger - 1)] = dl;
    }
    motion.take_up[i] = std::max(0.0, -motion.imposed[i]);
  }
}

// Slips up to a loop's circulation.
void accumulate_slip(const TendonSpan& tendon, Motion& motion) {
  double slip = 0;
  for (std::size_t k = 0; k < tendon.contacts; ++k) {
    slip -= motion.imposed[tendon.first_segment + k];
    motion.slip[tendon.first_contact + k] = std::abs(slip) < slip_tolerance ? 0 : slip;
  }
}

void impose_blocks(const Network& network, const TendonSpan& tendon, Direction direction,
                   Motion& motion) {
  const double way = direction == Direction::pull ? 1 : -1;
  for_each_pull(network, tendon, [&](std::size_t segment, std::size_t block, double sign, double) {
    motion.imposed[segment] += way * sign * motion.block_travel[block];
  });
}

// A bar lets no tendon through: on its left the arm takes up what is left over, on its right what
// then follows from the pivot's way. Its slip is the left arm's way beyond the pivot's.
void accumulate_slip_at_bars(const Network& network, const TendonSpan& tendon, Motion& motion) {
  double slip = 0;
  for (std::size_t k = 0; k < tendon.contacts; ++k) {
    const Contact& contact = network.contacts[tendon.first_contact + k];
    slip -= motion.imposed[tendon.first_segment + k];
    motion.slip[tendon.first_contact + k] = std::abs(slip) < slip_tolerance ? 0 : slip;
    if (contact.kind == ContactKind::bar) slip /= behind_bar(network, contact);
  }
}

void add_circulation(const TendonSpan& tendon, double circulation, Motion& motion) {
  for (std::size_t k = tendon.first_contact; k < tendon.first_contact + tendon.contacts; ++k) {
    motion.slip[k] += circulation;
    if (std::abs(motion.slip[k]) < slip_tolerance) motion.slip[k] = 0;
  }
}

void leave_slack(const TendonSpan& tendon, Motion& motion) {
  const auto clear = [](std::vector<double>& values, std::size_t first, std::size_t count) {
    std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(first), count, 0.0);
  };
  clear(motion.imposed, tendon.first_segment, tendon.segments);
  clear(motion.take_up, tendon.first_segment, tendon.segments);
  clear(motion.slip, tendon.first_contact, tendon.contacts);
}

void mark_slack(const Network& network, std::size_t tendon, Motion& motion) {
  motion.slack.resize(network.tendons.size(), 0);
  motion.slack[tendon] = 1;
}

bool some_end_moves(const Network& network, const Mechanics& mechanics, const Grasp& grasp) {
  return std::any_of(network.tendons.begin(), network.tendons.end(), [&](const TendonSpan& tendon) {
    return tally(network, tendon, mechanics, grasp).is_driven;
  });
}

// True if every end at a motor travels D, none of them behind slack.
bool ends_move_alike(const Network& network, const Mechanics& mechanics, const Grasp& grasp) {
  if (!mechanics.slack_mm.empty()) return false;
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    if (network.segments[i].kind != SegmentKind::motor_side) continue;
    if (end_travel(network, mechanics, grasp, i) != 1) return false;
  }
  return true;
}

// A blocked carriage moves nothing, on no tendon.
void stop_everything(Motion& motion) {
  std::fill(motion.block_travel.begin(), motion.block_travel.end(), 0.0);
  std::fill(motion.slip.begin(), motion.slip.end(), 0.0);
  std::fill(motion.closing.begin(), motion.closing.end(), 0.0);
}

}  // namespace

double taut_share(const Network& network, const TendonSpan& tendon, const Mechanics& mechanics,
                  const Grasp& grasp) {
  return mechanics.slack_mm.empty() ? 1 : tally(network, tendon, mechanics, grasp).taut;
}

GuideUse guide_use(const Network& network, const Mechanics& mechanics, std::size_t contact,
                   const std::vector<double>& slip, const std::vector<double>& closing) {
  constexpr double rounding = 1e-9;
  if (mechanics.guides(contact) == 0) return GuideUse::whole;
  const double closes = closing[static_cast<std::size_t>(network.contacts[contact].finger) - 1];
  const double more = std::abs(slip[contact]) - closes;
  if (closes > 0 && std::abs(more) <= rounding * closes) return GuideUse::one_strand_rests;
  return more < 0 ? GuideUse::alike : GuideUse::whole;
}

Slide slide_at(const Network& network, const Mechanics& mechanics, const Motion& motion,
               const TendonSpan& tendon, std::size_t contact) {
  const bool holds = tendon.closed && guide_use(network, mechanics, contact, motion.slip,
                                                motion.closing) == GuideUse::one_strand_rests;
  return holds ? Slide::no : slide_of(motion.slip[contact]);
}

double Kinematics::circulation(const Network& network, const TendonSpan& tendon,
                               const Mechanics& mechanics, const Motion& motion) {
  points_.clear();
  double total = 0;
  for (std::size_t k = tendon.first_contact; k < tendon.first_contact + tendon.contacts; ++k) {
    const double guides = mechanics.guides(k);
    points_.push_back({-motion.slip[k], mechanics.phi[k] - guides});
    total += mechanics.phi[k];
    if (guides == 0) continue;
    const double dl = motion.closing[static_cast<std::size_t>(network.contacts[k].finger) - 1];
    points_.push_back({dl - motion.slip[k], guides / 2});
    points_.push_back({-dl - motion.slip[k], guides / 2});
  }
  std::sort(points_.begin(), points_.end(),
            [](const WeightedPoint& a, const WeightedPoint& b) { return a.at < b.at; });
  // The median is always the breakpoint of some contact: that one holds, and the tension solver
  // opens the loop there. Where a whole interval is as good, either end gives the same tensions.
  double below = 0;
  for (const WeightedPoint& point : points_) {
    below += point.weight;
    if (below >= total / 2) return point.at;
  }
  return points_.back().at;
}

void Kinematics::settle_slip(const Network& network, const TendonSpan& tendon,
                             const Mechanics& mechanics, Direction direction, Motion& motion) {
  if (!network.blocks.empty()) impose_blocks(network, tendon, direction, motion);
  if (tendon.closed || network.blocks.empty()) {
    accumulate_slip(tendon, motion);
  } else {
    accumulate_slip_at_bars(network, tendon, motion);
  }
  if (tendon.closed)
    add_circulation(tendon, circulation(network, tendon, mechanics, motion), motion);
}

void Kinematics::solve_tree(const Network& network, const Mechanics& mechanics, Grasp grasp,
                            Direction direction, std::size_t tree, Motion& motion) {
  const TreeState moves =
      solve_tree_kinematics(network, mechanics, grasp, tree, motion.closing, motion.block_travel);
  const auto found = [&](const Segment& segment) {
    return motion.closing[static_cast<std::size_t>(segment.finger - 1)];
  };
  bool has_motor_side = false;
  for (std::size_t t = 0; t < network.tendons.size(); ++t) {
    const TendonSpan& tendon = network.tendons[t];
    if (tendon.tree != tree) continue;
    has_motor_side |= tally(network, tendon, mechanics, grasp).has_motor_side;
    if (!moves.slack.empty() && moves.slack[t] != 0) {
      mark_slack(network, t, motion);
      leave_slack(tendon, motion);
      continue;
    }
    if (moves.moves()) {
      impose_travel(network, mechanics, tendon, grasp, direction, found, motion);
    } else {
      motion.jams[t] = 1;
      impose_jam(network, tendon, mechanics, grasp, direction, motion);
    }
    settle_slip(network, tendon, mechanics, direction, motion);
  }
  if (moves.fault != TensionFault::none) motion.fault = moves.fault;
  if (!has_motor_side) motion.fault = TensionFault::no_motor;
}

void Kinematics::solve_split(const Network& network, const Mechanics& mechanics, Grasp grasp,
                             Direction direction, Motion& motion) {
  if (network.shared && (network.split || !mechanics.slack_mm.empty())) {
    motion.fault = TensionFault::beside_second_tendon;
  } else if (network.split && !ends_move_alike(network, mechanics, grasp)) {
    motion.fault = TensionFault::ends_unlike_at_seizure;
  }
  SplitClosing split = network.shared ? shared_closing(network, mechanics, grasp)
                                      : split_closing(network, mechanics, grasp);
  if (split.fault != TensionFault::none) motion.fault = split.fault;
  motion.opposed = split.opposed;
  motion.block_travel = split.block_travel;
  const auto found = [&](const Segment& segment) {
    return split.closing[static_cast<std::size_t>(segment.finger - 1)];
  };
  std::fill(motion.slip.begin(), motion.slip.end(), 0.0);
  for (std::size_t t = 0; t < network.tendons.size(); ++t) {
    const TendonSpan& tendon = network.tendons[t];
    if (split.jams[t] != 0) {
      impose_jam(network, tendon, mechanics, grasp, direction, motion);
    } else {
      impose_travel(network, mechanics, tendon, grasp, direction, found, motion);
    }
    if (split.slack[t] != 0) continue;
    settle_slip(network, tendon, mechanics, direction, motion);
  }
  motion.jams = std::move(split.jams);
  motion.slack = std::move(split.slack);
  if (std::find(motion.jams.begin(), motion.jams.end(), 1) != motion.jams.end()) {
    stop_everything(motion);
  }
}

void Kinematics::solve_tendon(const Network& network, const Mechanics& mechanics,
                              const Grasp& grasp, Direction direction, std::size_t t,
                              Motion& motion) {
  const TendonSpan& tendon = network.tendons[t];
  const TendonTally sums = tally(network, tendon, mechanics, grasp);
  if (sums.taut == 0 || (sums.has_motor_side && !sums.is_driven)) mark_slack(network, t, motion);
  if (sums.taut == 0) {
    leave_slack(tendon, motion);
    return;
  }
  if (sums.motor_sides < 0) motion.fault = TensionFault::finger_opens;
  if (!sums.has_motor_side) motion.fault = TensionFault::no_motor;
  const bool needs_no_finger = sums.has_motor_side && sums.motor_sides == 0;
  if (sums.closing_weight == 0 && !needs_no_finger) {
    motion.jams[t] = 1;
    impose_jam(network, tendon, mechanics, grasp, direction, motion);
  } else {
    const auto shared = [&](const Segment& segment) {
      return sums.motor_sides * closing_weight(segment, mechanics) / sums.closing_weight;
    };
    impose_travel(network, mechanics, tendon, grasp, direction, shared, motion);
  }
  for (std::size_t i = tendon.first_segment; i < tendon.first_segment + tendon.segments; ++i) {
    motion.take_up[i] *= sums.taut;
  }
  accumulate_slip(tendon, motion);
  if (tendon.closed)
    add_circulation(tendon, circulation(network, tendon, mechanics, motion), motion);
}

void Kinematics::solve(const Network& network, const Mechanics& mechanics, Grasp grasp,
                       Direction direction, Motion& motion) {
  motion.jams.assign(network.tendons.size(), 0);
  motion.imposed.resize(network.segments.size());
  motion.take_up.resize(network.segments.size());
  motion.slip.resize(network.contacts.size());
  motion.closing.assign(static_cast<std::size_t>(network.fingers), 0.0);
  motion.block_travel.assign(network.blocks.size(), 0.0);
  motion.fault = TensionFault::none;
  motion.slack.clear();
  motion.opposed = 0;
  if (network.split || network.shared) {
    solve_split(network, mechanics, grasp, direction, motion);
    return;
  }
  bool blocked = false;
  for (std::size_t t = 0; t < network.tendons.size(); ++t) {
    const TendonSpan& tendon = network.tendons[t];
    if (is_tied(network, tendon)) {
      if (tendon.tree == t) solve_tree(network, mechanics, grasp, direction, t, motion);
      blocked |= motion.jams[t] != 0;
      continue;
    }
    solve_tendon(network, mechanics, grasp, direction, t, motion);
    blocked |= motion.jams[t] != 0;
  }
  if (blocked) stop_everything(motion);
  if (!motion.slack.empty() &&
      std::find(motion.slack.begin(), motion.slack.end(), 0) == motion.slack.end()) {
    motion.fault = mechanics.slack_mm.empty() && !some_end_moves(network, mechanics, grasp)
                       ? TensionFault::nothing_pulls
                       : TensionFault::slack_remains;
  }
}

}  // namespace reeve::core
