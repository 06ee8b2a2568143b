// A goal of one routing, under whatever model.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/routing.hpp"
#include "search/evaluate/objectives.hpp"
#include "search/evaluate/score.hpp"
#include "sizing/goal.hpp"

namespace reeve::sizing {

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

}  // namespace reeve::sizing
