// One design in all its grasps: the bridge from the tension model to the objectives.
#pragma once

#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/tension.hpp"
#include "search/objectives.hpp"

namespace reeve {

// Keeps its memory: evaluating routing after routing allocates nothing in the steady state.
// One for each thread.
class DesignEvaluator {
 public:
  DesignEvaluator(const Hardware& hardware, GraspSet grasps);

  // The outcome is valid until the next call. Two tension solves a grasp: pull and release.
  const DesignOutcome& outcome(const Routing& routing);

  ObjectiveValues evaluate(const Routing& routing);

  // All objectives but return friction, which is left at 0, in half the time: one solve a grasp.
  ObjectiveValues evaluate_pulling(const Routing& routing);

 private:
  enum class Extent { pulling, pulling_and_releasing };

  const DesignOutcome& outcome(const Routing& routing, Extent extent);
  GraspOutcome in_grasp(const WeightedGrasp& grasp, Extent extent);

  MechanicsBuilder builder_;
  GraspSet grasps_;
  Network network_;
  Mechanics mechanics_;
  TensionSolver solver_;
  TensionState state_;
  DesignOutcome outcome_;
};

}  // namespace reeve
