#include "sizing/goal_evaluator.hpp"

#include <cmath>
#include <utility>

#include "causes/model_solver.hpp"
#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"

namespace reeve::sizing {

using Eigen::Index;

GoalEvaluator::GoalEvaluator(const Routing& routing, Goal goal, GraspSet grasps, Score score)
    : routing_(routing),
      network_(expand(routing)),
      goal_(std::move(goal)),
      grasps_(std::move(grasps)),
      weights_(static_cast<Index>(grasps_.size())),
      score_(std::move(score)) {
  for (std::size_t g = 0; g < grasps_.size(); ++g) {
    weights_[static_cast<Index>(g)] = grasps_[g].weight;
  }
  weights_ /= weights_.sum();
}

double GoalEvaluator::value(const Model& model) const {
  if (goal_.is_target()) return misses(model).norm();
  DesignEvaluator evaluator(model, grasps_, score_);
  const ObjectiveValues values = evaluator.evaluate(routing_, scope_for(goal_.factors, score_));
  double product = 1;
  for (const Objective factor : goal_.factors) product *= search::value(values, factor);
  return product;
}

Eigen::MatrixXd GoalEvaluator::shares_by_grasp(const Model& model) const {
  ModelSolver solver(model, possible_hardware(model), to_word(routing_), network_);
  Eigen::MatrixXd shares =
      Eigen::MatrixXd::Zero(static_cast<Index>(grasps_.size()), network_.fingers);
  for (std::size_t g = 0; g < grasps_.size(); ++g) {
    const Grasp grasp = grasps_[g].grasp;
    const TensionState& state =
        require_in_range(solver.solve(grasp, Direction::pull, model.conditions), grasp);
    auto row = shares.row(static_cast<Index>(g));
    for (std::size_t i = 0; i < network_.segments.size(); ++i) {
      const Segment& segment = network_.segments[i];
      if (segment.kind == SegmentKind::strand) row[segment.finger - 1] += state.tension[i];
    }
    const double sum = row.sum();
    if (sum > 0) row /= sum;
  }
  return shares;
}

Eigen::VectorXd GoalEvaluator::misses(const Model& model) const {
  const Eigen::MatrixXd shares = shares_by_grasp(model);
  Eigen::VectorXd misses(shares.size());
  for (Index g = 0; g < shares.rows(); ++g) {
    for (Index f = 0; f < shares.cols(); ++f) {
      misses[g * shares.cols() + f] =
          std::sqrt(weights_[g]) * (shares(g, f) - goal_.target[static_cast<std::size_t>(f)]);
    }
  }
  return misses;
}

std::vector<double> GoalEvaluator::shares(const Model& model) const {
  const Eigen::VectorXd mean = shares_by_grasp(model).transpose() * weights_;
  return {mean.begin(), mean.end()};
}

ObjectiveValues GoalEvaluator::objectives(const Model& model, std::uint64_t& unconverged) const {
  DesignEvaluator evaluator(model, grasps_, score_);
  const ObjectiveValues values = evaluator.evaluate(routing_);
  unconverged += evaluator.unconverged();
  return values;
}

}  // namespace reeve::sizing
