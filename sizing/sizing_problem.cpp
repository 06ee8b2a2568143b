#include "sizing/sizing_problem.hpp"

#include <cmath>
#include <utility>

#include "causes/model_solver.hpp"
#include "core/error.hpp"
#include "core/network.hpp"
#include "core/notation.hpp"
#include "core/performance.hpp"
#include "numerics/robust.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/uncertainty/coefficient_box.hpp"

namespace reeve::sizing {
namespace {

// Worse than any goal, but finite, so that it can be compared.
constexpr double worst_loss = 1e9;

// Returns the corner of the box with the greatest friction that is drawn.
std::vector<double> upper_corner(const SizingOptions& options) {
  std::vector<double> highest;
  for (const Interval& interval : coefficient_box(options.nominal.hardware, options.ranges)) {
    highest.push_back(interval.high);
  }
  return highest;
}

}  // namespace

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
    const FingerArray pulls = pulls_by_finger(network_, state);
    for (int f = 0; f < network_.fingers; ++f) {
      row[f] = std::abs(pulls[static_cast<std::size_t>(f) + 1]);
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

SizingProblem::SizingProblem(const Routing& routing, const SizingOptions& options)
    : nominal_model_(options.nominal),
      space_(size_space(expand(routing), options.nominal.hardware, options.varied, options.equal)),
      evaluator_(routing, options.goal, goal_grasps(options), options.score),
      higher_is_better_(options.goal.better() == Better::higher),
      robust_(options.robust),
      draws_(options.robust ? options.draws : 0),
      told_draws_(options.robust ? told_draws(options) : 0),
      seed_(options.seed),
      ranges_(options.ranges) {
  for (const SizeVariable& variable : space_.variables) box_.push_back(variable.bounds);
  for (const PlacedDimension& placed : space_.dimensions) nominal_.push_back(placed.nominal);
  if (robust_) highest_ = upper_corner(options);
  require_upper_end();
}

// Returns the model with the greatest friction that is drawn.
Model SizingProblem::upper_end(const Values& values) const {
  const Model model = model_of(values);
  return robust_ ? at_point(model, highest_) : model;
}

// Checks the hardware at the upper end. Faults of contacts alone are not found; points without
// tensions are passed over.
void SizingProblem::require_upper_end() const {
  SizingPoint highest;
  for (const Interval& interval : box_) highest.push_back(interval.high);
  try {
    validate(effective_hardware(upper_end(values(highest))));
  } catch (const InputError& error) {
    throw error.at(robust_ ? "at the upper end of the bounds and of the uncertainty's ranges"
                           : "at the upper end of the bounds");
  }
}

bool SizingProblem::is_hardware(const SizingPoint& point) const {
  bool within = true;
  for (std::size_t v = 0; v < point.size(); ++v) {
    within = within && point[v] >= box_[v].low && point[v] <= box_[v].high;
  }
  return within || !fault(effective_hardware(upper_end(values(point))));
}

SizingPoint SizingProblem::nearest_to_nominal() const {
  SizingPoint point;
  for (const SizeVariable& variable : space_.variables) {
    point.push_back(std::clamp(variable.nominal, variable.bounds.low, variable.bounds.high));
  }
  return point;
}

SizingProblem::Values SizingProblem::values(const SizingPoint& point) const {
  Values values(space_.dimensions.size());
  for (std::size_t v = 0; v < space_.variables.size(); ++v) {
    for (const std::size_t dimension : space_.variables[v].dimensions) values[dimension] = point[v];
  }
  return values;
}

Model SizingProblem::model_of(const Values& values) const {
  Model model = nominal_model_;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const PlacedDimension& placed = space_.dimensions[i];
    // Unchanged values are not written into the hardware.
    if (values[i] == placed.nominal) continue;
    set(model.hardware, placed.dimension, values[i]);
  }
  return model;
}

double SizingProblem::goal_of(const Values& values, std::size_t draws) const {
  const Model model = model_of(values);
  if (draws == 0) return evaluator_.value(model);
  std::vector<double> goals;
  for (std::size_t d = 0; d < draws; ++d) {
    goals.push_back(evaluator_.value(draw_model(model, ranges_, seed_, d)));
  }
  return quantile_of(std::move(goals), higher_is_better_ ? robust_quantile : 1 - robust_quantile);
}

double SizingProblem::guarded_loss(const SizingPoint& point, std::size_t draws) const {
  if (!is_hardware(point)) return worst_loss;
  try {
    const double loss = as_loss(goal_of(values(point), draws));
    return std::isfinite(loss) ? loss : worst_loss;
  } catch (const OutOfRange&) {
    return worst_loss;
  }
}

double SizingProblem::loss(const SizingPoint& point) const { return guarded_loss(point, draws_); }

double SizingProblem::nominal_loss(const SizingPoint& point) const {
  return guarded_loss(point, 0);
}

}  // namespace reeve::sizing
