#include "search/evaluate/shared_states.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
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

SharedStates::Tree SharedStates::solved(const Routing& routing) {
  expand(routing, network_);
  builder_.apply(network_, mechanics_);
  Tree tree;
  tree.segments = network_.segments.size();
  for (std::size_t i = 0; i < tree.segments; ++i) {
    if (network_.segments[i].kind == SegmentKind::motor_side) tree.motor_sides.push_back(i);
  }
  tree.fingers = static_cast<std::size_t>(network_.fingers);
  for (std::size_t held = 0; held <= tree.fingers; ++held) {
    const Grasp grasp{held == 0 ? 0 : std::uint64_t{1} << (held - 1)};
    for (const Direction direction : {Direction::pull, Direction::release}) {
      solver_.solve_relative(network_, mechanics_, grasp, direction, alone_);
      tree.marks.push_back({alone_.jams, alone_.in_range});
      tree.numbers.insert(tree.numbers.end(), alone_.tension.begin(), alone_.tension.end());
      tree.numbers.insert(tree.numbers.end(), alone_.closing.begin(), alone_.closing.end());
    }
  }
  return tree;
}

const SharedStates::Tree& SharedStates::tree(const Routing& routing, const TreeSpan& span) {
  const auto found = known_.find(span.key);
  if (found != known_.end()) return found->second;
  copy_tree(routing, span, part_);
  return known_.emplace(span.key, solved(part_)).first->second;
}

bool SharedStates::set_routing(const Routing& routing) {
  if (!split_into_trees(routing, spans_) || spans_.size() < 2) return false;
  if (known_.size() + spans_.size() > most_shared_trees) known_.clear();
  trees_.clear();
  segments_ = 0;
  fingers_ = 0;
  for (const TreeSpan& span : spans_) {
    trees_.push_back(&tree(routing, span));
    segments_ += trees_.back()->segments;
    fingers_ += trees_.back()->fingers;
  }
  return true;
}

// Finds the state of each tree, and whether one of them jams.
bool SharedStates::mark(Grasp grasp, Direction direction, TensionState& state) {
  state.jams = false;
  state.in_range = true;
  states_.clear();
  for (std::size_t t = 0; t < trees_.size(); ++t) {
    states_.push_back(2 * held_in_tree(spans_[t], grasp) +
                      (direction == Direction::release ? 1 : 0));
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
    const double* const alone = tree.numbers.data() + states_[t] * (tree.segments + tree.fingers);
    if (state.jams && !tree.marks[states_[t]].jams) {
      std::fill_n(tension, tree.segments, 0.0);
    } else {
      std::copy_n(alone, tree.segments, tension);
      for (const std::size_t segment : tree.motor_sides) motor += alone[segment];
    }
    if (state.jams) {
      std::fill_n(closing, tree.fingers, 0.0);
    } else {
      std::copy_n(alone + tree.segments, tree.fingers, closing);
    }
    tension += tree.segments;
    closing += tree.fingers;
  }
  for (double& each : state.tension) each /= motor;
  return std::isnormal(motor);
}

}  // namespace reeve::search
