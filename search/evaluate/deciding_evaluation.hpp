// The objectives that decide what is kept of a stream of routings, and no others.
//
// Equal, bit for bit, to those that DesignEvaluator gives. Where all fingers are alike, no effect
// of the model depends on tensions or contacts, and grasps hold one finger at most, each tree of a
// routing is solved once and a routing is put together from its trees (shared_states.hpp).
// Otherwise, and where objectives need more than what the strands do, every routing is solved as a
// whole.
//
// Most designs are far from anything that is kept, and a few sums of their trees, or of those that
// they begin with (routing_beginning.hpp), are enough to know it.
#pragma once

#include <optional>
#include <vector>

#include "core/grasp.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/evaluate/loaded_trees.hpp"
#include "search/evaluate/routing_beginning.hpp"
#include "search/evaluate/tree_spans.hpp"

namespace reeve::search {

// Uniformity and motor efficiency over the grasps at best, from sums of trees.
//
// Beside a tree that jams the others are slack. A grasp that holds one finger changes one tree, so
// that the others are added up once for all of them.
class PerformanceOutliner {
 public:
  // The grasps must hold one finger at most. No efficiency is greater than `most_efficiency`.
  PerformanceOutliner(const GraspSet& grasps, double most_efficiency);

  // Returns nothing if a value leaves the range of a double, if there is no strand, or if trees jam
  // that are not all. The sums are of all states.
  std::optional<OutlinedPerformance> at_best(const RoutingBeginning& beginning);

 private:
  struct Weight {
    bool is_asked = false;
    double share = 0;  // share of all grasps
  };

  // For each tree, adds up the sums of the other trees with no finger held. Returns the sum of all.
  TreeSums add_up_others(const RoutingBeginning& beginning);

  double most_efficiency_;
  std::vector<Weight> weights_;  // [held finger]; 0: no finger held
  std::vector<TreeSums> others_;
};

// Bounds on the values that evaluate() would return. Of a beginning with open fingers there is none
// at worst.
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

  // True if routings are put together from trees, and no more is wanted than uniformity, efficiency
  // and parts.
  bool estimates_beginnings() const { return estimates_ && outliner_.has_value(); }
  // Bounds all routings that begin so. Returns nothing without estimates.
  std::optional<Estimate> estimate(const RoutingBeginning& beginning);
  // Also where friction depends on the load (loaded_trees.hpp).
  std::optional<Estimate> estimate(const Routing& routing);

  // Returns the same number as DesignEvaluator.
  std::size_t unconverged() const { return whole_.unconverged(); }

 private:
  Estimate enclosed(const OutlinedPerformance& at_best, const OutlinedPerformance& at_worst) const;

  std::vector<Objective> wanted_;
  Score score_;
  EvaluationScope extent_;
  bool scored_ = false;
  bool estimates_ = false;
  double greatest_exponent_ = 0;     // of any contact
  std::vector<Objective> of_parts_;  // wanted objectives that count parts
  DesignEvaluator whole_;
  std::optional<PerformanceOutliner> outliner_;  // where routings share trees
  std::optional<LoadedTrees> loaded_;

  // State of the current routing.
  std::vector<TreeSpan> spans_;
  RoutingBeginning beginning_;
  DesignOutcome outcome_;  // its parts alone
};

}  // namespace reeve::search
