// A routing's goal as a function of its variables, under coefficients that are not known well.
//
// A robust goal is that of the bad side: its 5 % quantile over draws of the coefficients (95 %
// where lower is better). The draws are the same at every point, so that points are compared on
// equal terms. A draw is that of uncertainty.hpp. The search uses few draws, and the results use as
// many as everywhere (told_draws).
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/routing.hpp"
#include "core/uncertainty_ranges.hpp"
#include "numerics/minimise.hpp"
#include "search/evaluate/objectives.hpp"
#include "search/evaluate/score.hpp"
#include "search/uncertainty/motor_force.hpp"
#include "sizing/goal.hpp"
#include "sizing/size_space.hpp"

namespace reeve::sizing {

// A goal of one routing, under whatever model.
class GoalEvaluator {
 public:
  GoalEvaluator(const Routing& routing, Goal goal, GraspSet grasps, Score score);

  const Routing& routing() const { return routing_; }

  // All throw OutOfRange where the model has no tensions.
  double value(const Model& model) const;
  // Returns, for each grasp and finger, share less target. The value of a target is the norm of
  // these.
  Eigen::VectorXd misses(const Model& model) const;
  // Returns the finger shares, mean over the grasps.
  std::vector<double> shares(const Model& model) const;

 private:
  Eigen::MatrixXd shares_by_grasp(const Model& model) const;

  Routing routing_;
  Network network_;
  Goal goal_;
  GraspSet grasps_;
  Eigen::VectorXd weights_;  // weights of the grasps; their sum is 1
  Score score_;
};

struct SizingOptions {
  Model nominal;
  UncertaintyRanges ranges;
  GraspSet grasps;  // grasps for objectives and motor force
  Score score = authors_score();
  Goal goal;
  // Grasps of a target, if they differ from `grasps`.
  std::optional<GraspSet> target_grasps = std::nullopt;
  std::vector<VariedRange> varied;
  std::vector<EqualGroup> equal;
  bool robust = true;
  std::size_t draws = 100;  // at least 1
  std::uint64_t seed = 1;   // seed of draws and starts
  int starts = 6;           // number of local searches; the first starts at the nominal dimensions
  int evaluations = 1000;   // limit for each search
  int threads = 0;
};

inline constexpr double robust_quantile = 0.05;

// Returns the grasps in which the goal is judged.
inline const GraspSet& goal_grasps(const SizingOptions& options) {
  return options.target_grasps ? *options.target_grasps : options.grasps;
}

// Returns the number of draws of a result; its motor force is then that of the other subcommands
// (motor_force.hpp).
inline std::size_t told_draws(const SizingOptions& options) {
  return std::max(options.draws, motor_draws);
}

using SizingPoint = std::vector<double>;  // parallel to the variables

class SizingProblem {
 public:
  // Throws InputError if the variables' upper ends are out of the range of the hardware.
  SizingProblem(const Routing& routing, const SizingOptions& options);

  const SizeSpace& space() const { return space_; }
  const std::vector<Interval>& box() const { return box_; }
  SizingPoint nearest_to_nominal() const;

  // Returns the goal that the search improves. Throws OutOfRange.
  double goal(const SizingPoint& point) const { return goal_of(values(point), draws_); }
  // Returns the goal over the draws of a result; without a point, that of the hardware as it is.
  double told_goal() const { return goal_of(nominal_, told_draws_); }
  double told_goal(const SizingPoint& point) const { return goal_of(values(point), told_draws_); }
  // Return the goal at the nominal coefficients.
  double nominal_goal() const { return goal_of(nominal_, 0); }
  double nominal_goal(const SizingPoint& point) const { return goal_of(values(point), 0); }

  // Within the bounds always; beyond them a length may be none, or a wrap more than contacts have.
  bool is_hardware(const SizingPoint& point) const;

  // The goal, so that less is better; very much where there are no tensions, no hardware, or where
  // no motor is enough.
  double loss(const SizingPoint& point) const;
  double nominal_loss(const SizingPoint& point) const;
  double as_loss(double goal) const { return higher_is_better_ ? -goal : goal; }

  Model model(const SizingPoint& point) const { return model_of(values(point)); }
  const Model& model() const { return nominal_model_; }
  const Routing& routing() const { return evaluator_.routing(); }
  const GoalEvaluator& evaluator() const { return evaluator_; }

 private:
  using Values = std::vector<double>;  // parallel to the dimensions

  Values values(const SizingPoint& point) const;
  Model model_of(const Values& values) const;
  // Returns the quantile over so many draws; with 0, the goal at the nominal coefficients.
  double goal_of(const Values& values, std::size_t draws) const;
  double guarded_loss(const SizingPoint& point, std::size_t draws) const;
  Model upper_end(const Values& values) const;
  void require_upper_end() const;

  Model nominal_model_;
  SizeSpace space_;
  std::vector<Interval> box_;
  Values nominal_;
  GoalEvaluator evaluator_;
  bool higher_is_better_;
  bool robust_;
  std::size_t draws_;       // draws of the search
  std::size_t told_draws_;  // draws of the result
  std::uint64_t seed_;
  UncertaintyRanges ranges_;
  std::vector<double> highest_;  // upper end of all coefficients that are drawn
};

}  // namespace reeve::sizing
