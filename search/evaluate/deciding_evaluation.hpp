// The objectives that decide what is kept of a stream of routings, and no others.
//
// Equal, bit for bit, to those that DesignEvaluator gives. Where all fingers are alike, no effect
// of the model depends on tensions or contacts, and grasps hold one finger at most, each tree of a
// routing is solved once and a routing is put together from its trees (known_trees.hpp):
//
//   T_i = t_i / Σ t_j,  j: all motor-side segments
//
// with sums in the order of the routing's segments, as they would be without that. Otherwise, and
// where objectives need more than what the strands do, every routing is solved as a whole.
//
// Most designs are far from anything that is kept, and what a few sums of each tree say is enough
// to know it: an estimate, which is off by no more than rounding.
#pragma once

#include <optional>
#include <vector>

#include "core/grasp.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/evaluate/known_trees.hpp"
#include "search/evaluate/tree_spans.hpp"

namespace reeve::search {

// Uniformity and motor efficiency of a routing over its grasps, from the sums of its trees.
//
// In a grasp of which trees are in these states, least and greatest strand tension, motor tension
// and work are those of the trees together (known_trees.hpp):
//
//   uniformity = min_t least_t / max_t most_t,  efficiency = Σ_t work_t / Σ_t motor_t
//
// Beside a tree that jams the others are slack. A grasp that holds one finger changes one tree, so
// that the others are added up once for all of them.
struct OutlinedValue {
  double uniformity = 0;
  double efficiency = 0;
};

struct OutlinedPerformance {
  OutlinedValue mean;
  OutlinedValue worst;
};

class PerformanceOutliner {
 public:
  // The grasps must hold one finger at most.
  explicit PerformanceOutliner(const GraspSet& grasps);

  // Returns nothing if a value leaves the range of a double, or if there is no strand.
  std::optional<OutlinedPerformance> outlined(const std::vector<TreeSpan>& spans,
                                              const std::vector<const TreeOutline*>& trees);

 private:
  struct Weight {
    bool is_asked = false;
    double share = 0;  // share of all grasps
  };

  // For each tree, adds up the sums of the other trees with no finger held. False if one of them
  // then jams.
  bool add_up_others(const std::vector<const TreeOutline*>& trees);

  std::vector<Weight> weights_;  // [held finger]; 0: no finger held
  std::vector<TreeSums> others_;
};

// Bounds on the values that evaluate() would return.
struct Estimate {
  ObjectiveValues at_best{};
  ObjectiveValues at_worst{};
};

class DecidingEvaluator {
 public:
  // Values of objectives that are not wanted are 0.
  DecidingEvaluator(const Model& model, const GraspSet& grasps, const Score& score,
                    const std::optional<PartPrices>& prices, std::vector<Objective> wanted);

  // Throws OutOfRange where the model has no tensions.
  ObjectiveValues evaluate(const Routing& routing);

  // Returns the wanted objectives that count parts, which need no tensions; the others are 0.
  ObjectiveValues part_values(const Routing& routing);

  // Returns nothing if routings are not put together from trees, or if more is wanted than
  // uniformity, efficiency and parts.
  std::optional<Estimate> estimate(const Routing& routing);

  bool combines() const { return known_.has_value(); }
  // Trees solved so far; 0 where routings are solved as a whole.
  std::uint64_t trees_solved() const { return known_ ? known_->solved() : 0; }
  // Returns the same number as DesignEvaluator.
  std::size_t unconverged() const { return whole_.unconverged(); }

 private:
  bool combine(const Routing& routing);
  bool combine(const WeightedGrasp& grasp, GraspOutcome& outcome);
  double scale(bool jams) const;
  Performance performance_at(double motor, bool jams) const;
  FingerPulls finger_pulls_at(double motor, bool jams) const;
  double travel() const;
  double jams_all() const;
  void add_parts();
  double tendon_length() const;

  std::vector<Objective> wanted_;
  Score score_;
  std::optional<PartPrices> prices_;
  EvaluationScope extent_;
  bool scored_ = false;
  bool compares_fingers_ = false;
  bool estimates_ = false;
  std::vector<Objective> of_parts_;  // wanted objectives that count parts
  GraspSet grasps_;
  DesignEvaluator whole_;
  std::optional<KnownTrees> known_;
  PerformanceOutliner outliner_;

  // State of the current routing.
  std::vector<TreeSpan> spans_;
  const std::vector<const SolvedTrees*>* trees_ = nullptr;
  std::vector<SolvedTree> states_;  // states of its trees in one grasp
  DesignOutcome outcome_;
};

}  // namespace reeve::search
