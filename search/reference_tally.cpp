#include "search/reference_tally.hpp"

#include <algorithm>

#include "search/evaluate/evaluation.hpp"
#include "search/rank/pareto.hpp"

namespace reeve::search {

ReferenceTally::ReferenceTally(const ExploreOptions& options, std::size_t workers)
    : options_(options), dominators_(workers) {
  DesignEvaluator evaluator(options.model, options.grasps, options.score, options.prices);
  for (const Routing& routing : options.references) {
    goodness_.push_back(goodness(evaluator.evaluate(routing), options.order.objectives));
  }
  count_from_zero();
}

void ReferenceTally::count_from_zero() {
  for (std::vector<std::int64_t>& counts : dominators_) counts.assign(goodness_.size(), 0);
}

void ReferenceTally::go_on(const std::vector<ReferenceCount>& counted) {
  for (std::size_t r = 0; r < goodness_.size(); ++r) {
    dominators_.front()[r] = static_cast<std::int64_t>(counted[r].dominated_by);
  }
}

void ReferenceTally::count(const EvaluatedRouting& evaluated, std::size_t worker,
                           std::vector<ReferenceCount>& references) {
  add(evaluated, dominators_[worker], 1, references);
}

void ReferenceTally::take_off(const EvaluatedRouting& evaluated,
                              std::vector<ReferenceCount>& references) {
  add(evaluated, dominators_.front(), -1, references);
}

void ReferenceTally::add(const EvaluatedRouting& evaluated, std::vector<std::int64_t>& dominators,
                         int count, std::vector<ReferenceCount>& references) {
  for (std::size_t r = 0; r < goodness_.size(); ++r) {
    if (evaluated.routing != options_.references[r]) continue;
    references[r].generated = count > 0;
    references[r].rejected_by.reset();
    if (evaluated.failed_constraint > 0 && count > 0) {
      references[r].rejected_by = evaluated.failed_constraint - 1;
    }
  }
  if (evaluated.failed_constraint > 0 || goodness_.empty()) return;
  const Goodness candidate = goodness(evaluated.values, options_.order.objectives);
  for (std::size_t r = 0; r < goodness_.size(); ++r) {
    if (dominates(candidate, goodness_[r])) dominators[r] += count;
  }
}

bool ReferenceTally::agree(const Estimate& estimate) const {
  const Goodness best = goodness(estimate.at_best, options_.order.objectives);
  const Goodness worst = goodness(estimate.at_worst, options_.order.objectives);
  return std::all_of(goodness_.begin(), goodness_.end(), [&](const Goodness& reference) {
    return dominates(best, reference) == dominates(worst, reference);
  });
}

void ReferenceTally::add_up(std::vector<ReferenceCount>& references) const {
  for (std::size_t r = 0; r < goodness_.size(); ++r) {
    std::int64_t sum = 0;
    for (const std::vector<std::int64_t>& dominators : dominators_) sum += dominators[r];
    references[r].dominated_by = static_cast<std::uint64_t>(sum);
  }
}

}  // namespace reeve::search
