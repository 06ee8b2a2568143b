#include "search/evaluate/solved_trees.hpp"

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
  states.length = mechanics_.length;
  states.strand_finger.clear();
  states.motor_sides = 0;
  for (const Segment& segment : network_.segments) {
    if (segment.kind == SegmentKind::motor_side) ++states.motor_sides;
    if (segment.kind != SegmentKind::strand) continue;
    states.strand_finger.push_back(static_cast<std::uint8_t>(segment.finger - 1));
  }
  states.outline.sums.clear();
  states.numbers_.clear();
  solve(Grasp{}, states);
  for (int f = 1; f <= network_.fingers; ++f) solve(Grasp{std::uint64_t{1} << (f - 1)}, states);
}

}  // namespace reeve::search
