// Where known routings stand among all that are searched: which of them were generated, what
// rejected them, and how many designs dominate each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/evaluate/deciding_evaluation.hpp"
#include "search/exploration_part.hpp"

namespace reeve::search {

struct EvaluatedRouting {
  const Routing& routing;
  const ObjectiveValues& values;  // those of the order and the constraints at least
  std::size_t failed_constraint;  // its number, from 1; 0: none
};

// Workers count for themselves; their sums do not depend on who counted what.
class ReferenceTally {
 public:
  ReferenceTally(const ExploreOptions& options, std::size_t workers);

  void count_from_zero();
  // What was counted before is the first worker's.
  void go_on(const std::vector<ReferenceCount>& counted);

  // Each routing is generated once, so no two workers write one count of the references.
  void count(const EvaluatedRouting& evaluated, std::size_t worker,
             std::vector<ReferenceCount>& references);
  // Of a routing that was counted, by whichever worker.
  void take_off(const EvaluatedRouting& evaluated, std::vector<ReferenceCount>& references);

  // Whether a design between these values is counted as one that has them.
  bool agree(const Estimate& estimate) const;

  void add_up(std::vector<ReferenceCount>& references) const;

 private:
  void add(const EvaluatedRouting& evaluated, std::vector<std::int64_t>& dominators, int count,
           std::vector<ReferenceCount>& references);

  const ExploreOptions& options_;
  std::vector<Goodness> goodness_;  // of the references
  // [worker][reference]; a worker's own count may fall below zero, their sum does not.
  std::vector<std::vector<std::int64_t>> dominators_;
};

}  // namespace reeve::search
