// Standing of known routings among all searched routings: whether each was generated, which
// constraint rejected it, and how many designs dominate it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/evaluate/deciding_evaluation.hpp"
#include "search/exploration_part.hpp"

namespace reeve::search {

struct EvaluatedRouting {
  const Routing& routing;
  const ObjectiveValues& values;  // has at least those of the order and the constraints
  std::size_t failed_constraint;  // its number, from 1; 0: none
};

// Workers count for themselves; their sums do not depend on who counted what.
class ReferenceTally {
 public:
  ReferenceTally(const ExploreOptions& options, std::size_t workers);

  void count_from_zero();
  // Credits all earlier counts to the first worker.
  void go_on(const std::vector<ReferenceCount>& counted);

  // Each routing is generated once, so no two workers write one count of the references.
  void count(const EvaluatedRouting& evaluated, std::size_t worker,
             std::vector<ReferenceCount>& references);
  // Undoes the count of a routing, whichever worker counted it.
  void take_off(const EvaluatedRouting& evaluated, std::vector<ReferenceCount>& references);

  // True if all values between the two estimates give the same count.
  bool agree(const Estimate& estimate) const;

  void add_up(std::vector<ReferenceCount>& references) const;

 private:
  void add(const EvaluatedRouting& evaluated, std::vector<std::int64_t>& dominators, int count,
           std::vector<ReferenceCount>& references);

  const ExploreOptions& options_;
  std::vector<Goodness> goodness_;  // one for each reference
  // [worker][reference]; a worker's own count may fall below zero, their sum does not.
  std::vector<std::vector<std::int64_t>> dominators_;
};

}  // namespace reeve::search
