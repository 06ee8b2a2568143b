#include "search/evaluate/shared_states.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/hand.hpp"

namespace reeve::search {
namespace {

// A few kilobytes each, of trees of up to some seven fingers.
constexpr std::size_t most_shared_trees = 8192;

}  // namespace

bool have_like_fingers(const Model& model) {
  const Hardware hardware = possible_hardware(model);
  return hardware.fingers.empty() && hardware.contacts.empty() && hardware.spools.empty() &&
         hardware.tendon.own.empty() && !hardware.contact_draw && !hand(hardware);
}

bool routings_share_states(const Model& model) {
  return !reaches(model, Reach::contact) && !changes_exponents(model) && have_like_fingers(model);
}

bool hold_one_finger_at_most(const GraspSet& grasps) {
  return std::all_of(grasps.begin(), grasps.end(), [](const WeightedGrasp& grasp) {
    return std::popcount(grasp.grasp.held) <= 1 && grasp.grasp.carriages.given == 0 &&
           grasp.grasp.locked == 0;
  });
}

std::size_t held_in_tree(const TreeSpan& span, Grasp grasp) {
  const int held = grasp.held == 0 ? 0 : std::countr_zero(grasp.held) + 1 - span.fingers_before;
  return held > 0 && held <= span.fingers ? static_cast<std::size_t>(held) : 0;
}

TreeSums sums_of(const Network& network, const TensionState& state, double unit_N) {
  TreeSums sums{state.jams, state.in_range, 0, {}};
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    const Segment& segment = network.segments[i];
    const double tension = unit_N * state.tension[i];
    if (segment.kind == SegmentKind::motor_side) sums.motor += tension;
    if (segment.kind != SegmentKind::strand) continue;
    sums.strands.add(tension, state.closing[static_cast<std::size_t>(segment.finger - 1)]);
  }
  return sums;
}

void SharedStates::make_room(std::size_t trees) {
  if (known_.size() + trees > most_shared_trees) known_.clear();
}

void SharedStates::solve_tree(const Routing& routing, const TreeSpan& span, Direction direction,
                              Tree& tree) {
  copy_tree(routing, span, part_);
  expand(part_, network_);
  builder_.apply(network_, mechanics_);
  if (direction == Direction::pull) start(tree);
  for (int held = 0; held <= network_.fingers; ++held) {
    const Grasp grasp{held == 0 ? 0 : std::uint64_t{1} << (held - 1)};
    solver_.solve_relative(network_, mechanics_, grasp, direction, alone_);
    if (direction == Direction::pull) tree.outline.sums.push_back(sums_of(network_, alone_));
    tree.marks.push_back({alone_.jams, alone_.in_range});
    tree.numbers.insert(tree.numbers.end(), alone_.tension.begin(), alone_.tension.end());
    tree.numbers.insert(tree.numbers.end(), alone_.closing.begin(), alone_.closing.end());
  }
}

void SharedStates::start(Tree& tree) const {
  tree = {{parts(network_), network_.fingers, {}}, network_.segments.size(), {}, {}, {}, 0};
  for (std::size_t i = 0; i < tree.segments; ++i) {
    if (network_.segments[i].kind == SegmentKind::motor_side) tree.motor_sides.push_back(i);
  }
}

void SharedStates::outline(const Routing& routing, const TreeSpan& span, Tree& tree) {
  const bool alone = span.end - span.begin == 1;
  if (alone && tendon_sums_.find(routing.tendons[span.begin], span.fingers, tree.outline)) return;
  solve_tree(routing, span, Direction::pull, tree);
}

const std::vector<const TreeOutline*>& SharedStates::outlines(const Routing& routing,
                                                              const std::vector<TreeSpan>& spans) {
  make_room(spans.size());
  outlines_.clear();
  const int fingers = spans.back().fingers_before + spans.back().fingers;
  for (const TreeSpan& span : spans) {
    Tree* tree = &greatest_;
    if (2 * span.fingers <= fingers + 1) {
      const auto [found, is_new] = known_.try_emplace(span.key);
      tree = &found->second;
      if (is_new) outline(routing, span, *tree);
    } else if (greatest_key_ != span.key) {
      greatest_key_ = span.key;
      outline(routing, span, greatest_);
    }
    outlines_.push_back(&tree->outline);
  }
  return outlines_;
}

bool SharedStates::set_routing(const Routing& routing) {
  if (!split_into_trees(routing, spans_) || spans_.size() < 2) return false;
  make_room(spans_.size());
  trees_.clear();
  segments_ = 0;
  fingers_ = 0;
  for (const TreeSpan& span : spans_) {
    Tree& tree = known_[span.key];
    const auto states = static_cast<std::size_t>(span.fingers) + 1;
    if (tree.marks.empty()) solve_tree(routing, span, Direction::pull, tree);
    if (tree.marks.size() == states) {
      solve_tree(routing, span, Direction::release, tree);
      // The grasp that holds all its fingers, which JamFinder leaves out, jams too.
      tree.moving = std::ldexp(1.0, span.fingers) - 1 - jam_finder_.grasps(network_, mechanics_);
    }
    trees_.push_back(&tree);
    segments_ += tree.segments;
    fingers_ += static_cast<std::size_t>(span.fingers);
  }
  return true;
}

// Finds the state of each tree, and whether one of them jams.
bool SharedStates::mark(Grasp grasp, Direction direction, TensionState& state) {
  state.jams = false;
  state.in_range = true;
  states_.clear();
  for (std::size_t t = 0; t < trees_.size(); ++t) {
    const std::size_t pulled = direction == Direction::pull ? 0 : trees_[t]->marks.size() / 2;
    states_.push_back(pulled + held_in_tree(spans_[t], grasp));
    const Mark& mark = trees_[t]->marks[states_.back()];
    state.jams |= mark.jams;
    state.in_range &= mark.in_range;
  }
  return state.in_range;
}

bool SharedStates::solve(Grasp grasp, Direction direction, TensionState& state) {
  if (!mark(grasp, direction, state)) return false;
  state.tension.resize(segments_);
  state.closing.resize(fingers_);
  double* tension = state.tension.data();
  double* closing = state.closing.data();
  double motor = 0;
  for (std::size_t t = 0; t < trees_.size(); ++t) {
    const Tree& tree = *trees_[t];
    const auto fingers = static_cast<std::size_t>(spans_[t].fingers);
    const double* const alone = tree.numbers.data() + states_[t] * (tree.segments + fingers);
    if (state.jams && !tree.marks[states_[t]].jams) {
      std::fill_n(tension, tree.segments, 0.0);
    } else {
      std::copy_n(alone, tree.segments, tension);
      for (const std::size_t segment : tree.motor_sides) motor += alone[segment];
    }
    if (state.jams) {
      std::fill_n(closing, fingers, 0.0);
    } else {
      std::copy_n(alone + tree.segments, fingers, closing);
    }
    tension += tree.segments;
    closing += fingers;
  }
  for (double& each : state.tension) each /= motor;
  return std::isnormal(motor);
}

double SharedStates::jams() const {
  double moving = 1;
  for (const Tree* tree : trees_) {
    if (!std::isfinite(tree->moving)) return std::numeric_limits<double>::infinity();
    moving *= tree->moving;
  }
  return std::ldexp(1.0, static_cast<int>(fingers_)) - 1 - moving;
}

}  // namespace reeve::search
