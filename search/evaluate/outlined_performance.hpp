// Uniformity and motor efficiency of a routing over its grasps, from the sums of its trees.
//
// In a grasp of which trees are in these states, least and greatest strand tension, motor tension
// and work are those of the trees together (solved_trees.hpp):
//
//   uniformity = min_t least_t / max_t most_t,  efficiency = Σ_t work_t / Σ_t motor_t
//
// Beside a tree that jams the others are slack. A grasp that holds one finger changes one tree, so
// that the others are added up once for all of them.
#pragma once

#include <optional>
#include <vector>

#include "core/grasp.hpp"
#include "search/evaluate/tree_outline.hpp"
#include "search/evaluate/tree_spans.hpp"

namespace reeve::search {

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
  // Of grasps that hold one finger at most.
  explicit PerformanceOutliner(const GraspSet& grasps);

  // Nothing where a figure leaves the range of a double, or there is no strand.
  std::optional<OutlinedPerformance> outlined(const std::vector<TreeSpan>& spans,
                                              const std::vector<const TreeOutline*>& trees);

 private:
  struct Weight {
    bool is_asked = false;
    double share = 0;  // of all grasps
  };

  // What each tree adds to, no finger held. False where one of them jams so.
  bool add_up_others(const std::vector<const TreeOutline*>& trees);

  std::vector<Weight> weights_;  // of no finger held, of finger 1, …
  std::vector<TreeSums> others_;
};

}  // namespace reeve::search
