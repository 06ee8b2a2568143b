// One design in all its grasps: the bridge from the tension model to the objectives.
//
// A model's effects on hardware, friction and contacts are in it, friction at the model's reference
// conditions; those on readings and records are the rig's and left out.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "causes/model.hpp"
#include "causes/model_solver.hpp"
#include "core/grasp.hpp"
#include "core/hand.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/part_prices.hpp"
#include "core/tension/jamming.hpp"
#include "core/tension/tension.hpp"
#include "search/evaluate/contact_quantiles.hpp"
#include "search/evaluate/objectives.hpp"
#include "search/evaluate/score.hpp"
#include "search/evaluate/shared_states.hpp"

namespace reeve::search {

// Selects the calculations besides the pull and its free by-products. Objectives that need a
// calculation left out stay at 0.
struct EvaluationScope {
  bool release = true;     // return friction; a second tension solve in each grasp
  bool indicators = true;  // core/indicators.hpp, and a score made of them
  bool hand = true;        // core/hand, of a hardware with a hand
  bool jamming = true;     // core/tension/jamming.hpp, in all grasps
  bool contacts = true;    // contact_quantiles.hpp; some dozens of tension solves in each grasp

  friend bool operator==(const EvaluationScope&, const EvaluationScope&) = default;
};

// Returns the scope that these objectives need; the score needs that of its terms.
EvaluationScope scope_for(const std::vector<Objective>& objectives, const Score& score);

// Keeps its memory: evaluating routing after routing allocates nothing in the steady state.
// One for each thread. (With a seized contact, evaluating allocates.)
class DesignEvaluator {
 public:
  DesignEvaluator(const Hardware& hardware, GraspSet grasps);
  // Without prices a design's cost is infinite.
  DesignEvaluator(const Model& model, GraspSet grasps, Score score = authors_score(),
                  std::optional<PartPrices> prices = std::nullopt);

  // Solves each tree of tendons once, if model and grasps allow it. This helps if many routings
  // share trees. The values stay the same, bit for bit.
  void share_trees();
  // Requires shared trees.
  SharedStates& shared_states() { return *shared_; }

  // The outcome is valid until the next call. Throws OutOfRange that names routing and grasp where
  // the model has no tensions.
  const DesignOutcome& outcome(const Routing& routing, const EvaluationScope& scope = {});

  // True if the model has tensions in all grasps.
  bool has_tensions(const Routing& routing);

  // True if the hardware has a hand. Routings with fingers that it does not know have none.
  bool has_hand() const { return hand_.has_value(); }

  ObjectiveValues evaluate(const Routing& routing, const EvaluationScope& scope = {});

  // The smallest sets of held fingers with which it jams (core/tension/jamming.hpp).
  std::vector<Grasp> smallest_jams(const Routing& routing);

  // Solves so far that did not converge: friction that depends on the tension, and forces that eat
  // nearly all of it. Their figures are then approximate.
  std::size_t unconverged() const { return unconverged_; }

 private:
  void set_routing(const Routing& routing);
  void find_outcome(const Routing& routing, const EvaluationScope& scope);
  const Network& moving_network() const;
  const Mechanics& moving_mechanics() const;
  GraspOutcome in_grasp(const WeightedGrasp& grasp, const EvaluationScope& scope);
  const TensionState& try_solve(Grasp grasp, Direction direction);
  // Throws OutOfRange where there are no tensions.
  const TensionState& solve(Grasp grasp, Direction direction);
  double release_efficiency(Grasp grasp);
  const Mechanics& solved_mechanics();  // of the last solve
  double travel();
  double jams();  // in all grasps
  bool evaluates_hand(const EvaluationScope& scope) const;
  GripDemand grip(const TensionState& pulled, Grasp grasp);
  HandOutcome hand_outcome();
  SeriesStretch stretch_from(const Grasp& open) const;
  ContactQuantiles contact_quantiles();

  std::shared_ptr<const Model> model_;  // stays in place for the solver if this moves
  // Set only if exponents or contacts differ from the hardware file; costs several solves.
  std::optional<ModelSolver> model_solver_;
  bool needs_word_ = false;
  std::size_t unconverged_ = 0;
  std::optional<SharedStates> shared_;
  bool is_shared_ = false;  // true for the current routing
  MechanicsBuilder builder_;
  std::optional<Hand> hand_;
  GraspSet grasps_;
  std::vector<Grasp> open_grasps_;
  Score score_;
  std::optional<PartPrices> prices_;
  Network network_;
  Mechanics mechanics_;
  TensionSolver solver_;
  Kinematics kinematics_;  // used for travel and stroke only
  ClosingAlike closing_alike_;
  double given_up_equivalent_ = 0;  // value of the current routing, if indicators are asked for
  Motion motion_;
  JamFinder jam_finder_;
  ContactQuantileFinder contact_finder_;
  std::vector<double> deviations_;  // σ of each contact
  std::string word_;                // set if it is needed
  TensionState state_;
  DesignOutcome outcome_;
};

}  // namespace reeve::search
