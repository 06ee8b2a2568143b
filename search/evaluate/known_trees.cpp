#include "search/evaluate/known_trees.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::search {

SolvedTree SolvedTrees::in_state(std::size_t held) const {
  const std::size_t strands = strand_finger.size();
  const double* const first = numbers_.data() + held * (motor_sides + 2 * strands);
  return {outline.sums[held].jams,
          outline.sums[held].in_range,
          {first, motor_sides},
          {first + motor_sides, strands},
          {first + motor_sides + strands, strands}};
}

void TreeSolver::solve(Grasp grasp, SolvedTrees& states) {
  solver_.solve_relative(network_, mechanics_, grasp, Direction::pull, state_);
  TreeSums sums{state_.jams, state_.in_range, 0, {}};
  std::vector<double>& numbers = states.numbers_;
  for (std::size_t i = 0; i < network_.segments.size(); ++i) {
    if (network_.segments[i].kind != SegmentKind::motor_side) continue;
    numbers.push_back(state_.tension[i]);
    sums.motor += state_.tension[i];
  }
  for (std::size_t i = 0; i < network_.segments.size(); ++i) {
    const Segment& segment = network_.segments[i];
    if (segment.kind != SegmentKind::strand) continue;
    numbers.push_back(state_.tension[i]);
    sums.strands.add(state_.tension[i],
                     state_.closing[static_cast<std::size_t>(segment.finger - 1)]);
  }
  states.outline.sums.push_back(sums);
  for (const std::uint8_t finger : states.strand_finger) numbers.push_back(state_.closing[finger]);
}

void TreeSolver::solve(const Routing& tree, SolvedTrees& states) {
  expand(tree, network_);
  builder_.apply(network_, mechanics_);
  states.outline.parts = parts(network_);
  states.outline.fingers = network_.fingers;
  states.length = mechanics_.length;
  states.strand_finger.clear();
  states.motor_sides = 0;
  for (const Segment& segment : network_.segments) {
    if (segment.kind == SegmentKind::motor_side) ++states.motor_sides;
    if (segment.kind != SegmentKind::strand) continue;
    states.strand_finger.push_back(static_cast<std::uint8_t>(segment.finger - 1));
  }
  // The grasp that holds all its fingers, which JamFinder leaves out, jams too.
  states.moving_sets =
      std::ldexp(1.0, network_.fingers) - 1 - jam_finder_.grasps(network_, mechanics_);
  states.outline.sums.clear();
  states.numbers_.clear();
  solve(Grasp{}, states);
  for (int f = 1; f <= network_.fingers; ++f) solve(Grasp{std::uint64_t{1} << (f - 1)}, states);
}

KnownTrees::KnownTrees(const Hardware& hardware, std::size_t sets)
    : tendon_sums_(hardware), solver_(hardware), table_(sets * ways) {}

void KnownTrees::solve(const Routing& routing, const TreeSpan& span, Place& place) {
  copy_tree(routing, span, tree_);
  solver_.solve(tree_, place.states);
  place.solved = true;
  ++solved_;
}

void KnownTrees::outline(const Routing& routing, const TreeSpan& span, Place& place) {
  place.key = span.key;
  place.solved = false;
  const bool alone = span.end - span.begin == 1;
  if (alone && tendon_sums_.find(routing.tendons[span.begin], span.fingers, place.states.outline)) {
    return;
  }
  solve(routing, span, place);
}

// Returns nothing if this routing uses all places of this hash.
KnownTrees::Place* KnownTrees::find(const Routing& routing, const TreeSpan& span) {
  const std::size_t set = hash(span.key) & (table_.size() / ways - 1);
  Place* const first = &table_[set * ways];
  Place* found = first;
  for (Place* place = first; place != first + ways; ++place) {
    if (place->asked > 0 && place->key == span.key) {
      place->asked = now_;
      return place;
    }
    if (place->asked < found->asked) found = place;
  }
  if (found->asked == now_) return nullptr;
  outline(routing, span, *found);
  found->asked = now_;
  return found;
}

bool KnownTrees::find(const Routing& routing, const std::vector<TreeSpan>& spans) {
  ++now_;
  found_.clear();
  const int fingers = spans.back().fingers_before + spans.back().fingers;
  for (const TreeSpan& span : spans) {
    Place* place = &greatest_;
    if (2 * span.fingers <= fingers + 1) {
      place = find(routing, span);
    } else if (greatest_.asked == 0 || greatest_.key != span.key) {
      outline(routing, span, greatest_);
      greatest_.asked = now_;
    }
    if (place == nullptr) return false;
    found_.push_back(place);
  }
  return true;
}

const std::vector<const TreeOutline*>& KnownTrees::outlines(const Routing& routing,
                                                            const std::vector<TreeSpan>& spans) {
  outlines_.clear();
  if (!find(routing, spans)) return outlines_;
  for (const Place* place : found_) outlines_.push_back(&place->states.outline);
  return outlines_;
}

const std::vector<const SolvedTrees*>& KnownTrees::states(const Routing& routing,
                                                          const std::vector<TreeSpan>& spans) {
  states_.clear();
  if (!find(routing, spans)) return states_;
  for (std::size_t t = 0; t < spans.size(); ++t) {
    if (!found_[t]->solved) solve(routing, spans[t], *found_[t]);
    states_.push_back(&found_[t]->states);
  }
  return states_;
}

}  // namespace reeve::search
