// A routing's goal as a function of its variables, under coefficients that are not known well.
//
// Robust, the goal is that of the bad side: its 5 % quantile over draws of the coefficients (95 %
// where lower is better), the same draws at every point, so that points are compared on equal
// terms. A draw is that of uncertainty.hpp; besides, sheath angles that are varied turn by the same
// factor as the others do, since posture bends whatever was mounted.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/routing.hpp"
#include "core/uncertainty_ranges.hpp"
#include "numerics/minimise.hpp"
#include "search/evaluate/objectives.hpp"
#include "search/evaluate/score.hpp"
#include "sizing/goal.hpp"
#include "sizing/size_space.hpp"

namespace reeve::sizing {

// A goal of one routing, under whatever model.
class GoalEvaluator {
 public:
  GoalEvaluator(const Routing& routing, Goal goal, GraspSet grasps, Score score);

  // All throw OutOfRange where the model has no tensions.
  double value(const Model& model) const;
  // Of a target, whose value is their norm: for each grasp and finger, share less target.
  Eigen::VectorXd misses(const Model& model) const;
  // Of the fingers, mean over the grasps.
  std::vector<double> shares(const Model& model) const;
  // Adds to `unconverged` the tension solves that did not converge.
  ObjectiveValues objectives(const Model& model, std::uint64_t& unconverged) const;

 private:
  Eigen::MatrixXd shares_by_grasp(const Model& model) const;

  Routing routing_;
  Network network_;
  Goal goal_;
  GraspSet grasps_;
  Eigen::VectorXd weights_;  // of the grasps, adding up to 1
  Score score_;
};

struct SizingOptions {
  Model nominal;
  UncertaintyRanges ranges;
  GraspSet grasps;
  Score score = authors_score();
  Goal goal;
  std::vector<VariedRange> varied;
  std::vector<SameGroup> same;
  bool robust = true;
  std::size_t draws = 100;  // at least 1
  std::uint64_t seed = 1;   // of draws and starts
  int starts = 6;           // of local searches, the first at the hardware as it is
  int evaluations = 1000;   // at most, of each search
  int threads = 0;
};

inline constexpr double robust_quantile = 0.05;

using SizingPoint = std::vector<double>;  // parallel to the variables

class SizingProblem {
 public:
  // Throws InputError if the variables' upper ends are out of the range of the hardware.
  SizingProblem(const Routing& routing, const SizingOptions& options);

  const SizeSpace& space() const { return space_; }
  const std::vector<Interval>& box() const { return box_; }
  SizingPoint nearest_to_nominal() const;

  // What is searched for; without a point, of the hardware as it is. Throw OutOfRange.
  double goal() const { return goal_of(nominal_, robust_); }
  double goal(const SizingPoint& point) const { return goal_of(values(point), robust_); }
  // At the nominal coefficients.
  double nominal_goal() const { return goal_of(nominal_, false); }
  double nominal_goal(const SizingPoint& point) const { return goal_of(values(point), false); }

  // Within the bounds always; beyond them a length may be none, or a wrap more than contacts have.
  bool is_hardware(const SizingPoint& point) const;

  // The goal, so that less is better; very much where there are no tensions, no hardware, or where
  // no motor is enough.
  double loss(const SizingPoint& point) const;
  double nominal_loss(const SizingPoint& point) const;
  double as_loss(double goal) const { return higher_is_better_ ? -goal : goal; }

  Model model(const SizingPoint& point) const { return model_of(values(point), 1); }
  const Model& model() const { return nominal_model_; }
  const GoalEvaluator& evaluator() const { return evaluator_; }

 private:
  using Values = std::vector<double>;  // parallel to the dimensions

  struct Draw {
    std::vector<double> coefficients;
    double sheath_factor = 1;
  };

  Values values(const SizingPoint& point) const;
  Model model_of(const Values& values, double sheath_factor) const;
  double goal_of(const Values& values, bool robust) const;
  double guarded_loss(const SizingPoint& point, bool robust) const;
  Model upper_end(const Values& values) const;
  void require_upper_end() const;

  Model nominal_model_;
  SizeSpace space_;
  std::vector<Interval> box_;
  Values nominal_;
  GoalEvaluator evaluator_;
  bool higher_is_better_;
  bool robust_;
  Draw highest_;  // of all that the uncertainty may draw
  std::vector<Draw> draws_;
};

}  // namespace reeve::sizing
