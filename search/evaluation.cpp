#include "search/evaluation.hpp"

#include <algorithm>
#include <utility>

namespace reeve {

DesignEvaluator::DesignEvaluator(const Hardware& hardware, GraspSet grasps)
    : builder_(hardware), grasps_(std::move(grasps)) {}

GraspOutcome DesignEvaluator::in_grasp(const WeightedGrasp& grasp, Extent extent) {
  GraspOutcome outcome;
  outcome.weight = grasp.weight;
  solver_.solve(network_, mechanics_, grasp.grasp, Direction::pull, state_);
  outcome.jams = state_.jams;
  outcome.pull = performance(network_, state_);
  if (extent == Extent::pulling) return outcome;
  solver_.solve(network_, mechanics_, grasp.grasp, Direction::release, state_);
  outcome.return_friction =
      return_friction(outcome.pull, performance(network_, state_, Direction::release));
  return outcome;
}

const DesignOutcome& DesignEvaluator::outcome(const Routing& routing, Extent extent) {
  expand(routing, network_);
  builder_.apply(network_, mechanics_);
  outcome_.grasps.clear();
  for (const WeightedGrasp& grasp : grasps_) outcome_.grasps.push_back(in_grasp(grasp, extent));
  outcome_.parts = parts(network_);
  const auto motor_sides =
      std::count_if(network_.segments.begin(), network_.segments.end(),
                    [](const Segment& segment) { return segment.kind == SegmentKind::motor_side; });
  outcome_.travel = 2.0 * network_.fingers / static_cast<double>(motor_sides);
  return outcome_;
}

const DesignOutcome& DesignEvaluator::outcome(const Routing& routing) {
  return outcome(routing, Extent::pulling_and_releasing);
}

ObjectiveValues DesignEvaluator::evaluate(const Routing& routing) {
  ObjectiveValues values{};
  compute_objectives(outcome(routing), values);
  return values;
}

ObjectiveValues DesignEvaluator::evaluate_pulling(const Routing& routing) {
  ObjectiveValues values{};
  compute_objectives(outcome(routing, Extent::pulling), values);
  return values;
}

}  // namespace reeve
