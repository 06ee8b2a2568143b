#include "search/evaluate/deciding_evaluation.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "search/evaluate/shared_states.hpp"

namespace reeve::search {
namespace {

using TallyValue = std::optional<OutlinedValue>;

TallyValue value_of(bool in_range, double motor, const StrandTally& strands) {
  if (!in_range || !std::isnormal(motor) || !(strands.most > 0)) return std::nullopt;
  return OutlinedValue{strands.least / strands.most, strands.work / motor};
}

TallyValue value_of(const TreeSums& moving, const TreeSums& jammed) {
  if (!jammed.jams) return value_of(moving.in_range, moving.motor, moving.strands);
  TallyValue value = value_of(moving.in_range && jammed.in_range, jammed.motor, jammed.strands);
  if (!value) return value;
  value->efficiency = 0;
  if (moving.has_strands()) value->uniformity = 0;
  return value;
}

// Returns value_of(others + state) without keeping the sum.
TallyValue value_beside(const TreeSums& others, const TreeSums& state) {
  if (state.jams) return value_of(others, state);
  StrandTally strands;
  strands.least = std::min(others.strands.least, state.strands.least);
  strands.most = std::max(others.strands.most, state.strands.most);
  strands.work = others.strands.work + state.strands.work;
  return value_of(others.in_range && state.in_range, others.motor + state.motor, strands);
}

TallyValue value_held(std::size_t held, const std::vector<const TreeOutline*>& trees) {
  TreeSums moving;
  TreeSums jammed;
  std::size_t before = 0;
  for (const TreeOutline* tree : trees) {
    const bool is_its_own = held > before && held < before + tree->sums.size();
    const TreeSums& sums = tree->sums[is_its_own ? held - before : 0];
    (sums.jams ? jammed : moving) += sums;
    before += static_cast<std::size_t>(tree->fingers);
  }
  return value_of(moving, jammed);
}

// Jams need no more than the trees.
bool are_of_strands(const EvaluationScope& scope) {
  return scope == EvaluationScope{false, false, false, scope.jamming, false};
}

std::vector<Objective> with_terms(std::vector<Objective> wanted, const Score& score) {
  if (std::find(wanted.begin(), wanted.end(), Objective::score) != wanted.end()) {
    for (const ScoreTerm& term : score.terms) wanted.push_back(term.objective);
  }
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  return wanted;
}

constexpr std::array of_parts{Objective::sheaths, Objective::pulleys, Objective::knots,
                              Objective::blocks, Objective::parts};
// Objectives of grasps that follow from the sums of the trees.
constexpr std::array of_sums{Objective::uniformity_mean, Objective::uniformity_worst,
                             Objective::efficiency_mean, Objective::efficiency_worst};

// Covers sums in another order and the rounding of values.
constexpr double estimate_margin = 1e-9;

bool contains(const auto& objectives, Objective objective) {
  return std::find(objectives.begin(), objectives.end(), objective) != objectives.end();
}

}  // namespace

PerformanceOutliner::PerformanceOutliner(const GraspSet& grasps, double most_efficiency)
    : most_efficiency_(most_efficiency), weights_(max_fingers + 1) {
  double all = 0;
  for (const WeightedGrasp& grasp : grasps) all += grasp.weight;
  for (const WeightedGrasp& grasp : grasps) {
    const std::uint64_t held = grasp.grasp.held;
    Weight& weight = weights_[held == 0 ? 0 : static_cast<std::size_t>(std::countr_zero(held)) + 1];
    weight.is_asked = true;
    weight.share += grasp.weight / all;
  }
}

TreeSums PerformanceOutliner::add_up_others(const RoutingBeginning& beginning) {
  const std::vector<const TreeOutline*>& trees = beginning.trees;
  others_.assign(trees.size(), TreeSums{});
  TreeSums before;
  for (std::size_t t = 0; t < trees.size(); ++t) {
    others_[t] = before;
    before += trees[t]->sums[0];
  }
  TreeSums behind;
  behind.motor = beginning.most_motor_tension;
  behind.strands.work = most_efficiency_ * beginning.most_motor_tension;
  for (std::size_t t = trees.size(); t-- > 0;) {
    others_[t] += behind;
    behind += trees[t]->sums[0];
  }
  return behind;
}

std::optional<OutlinedPerformance> PerformanceOutliner::at_best(const RoutingBeginning& beginning) {
  OutlinedPerformance result;
  const TreeSums free = add_up_others(beginning);
  if (free.jams && beginning.open > 0) return std::nullopt;
  std::size_t held = 0;
  const auto add = [&](const TallyValue& moving) {
    const Weight& weight = weights_[held];
    if (!weight.is_asked) return true;
    const TallyValue value = free.jams ? value_held(held, beginning.trees) : moving;
    if (value) result.add(weight.share, *value);
    return value.has_value();
  };
  const TallyValue not_held = value_of(free, {});
  if (!add(not_held)) return std::nullopt;
  for (std::size_t t = 0; t < beginning.trees.size(); ++t) {
    const TreeOutline& tree = *beginning.trees[t];
    for (std::size_t state = 1; state < tree.sums.size(); ++state) {
      ++held;
      if (!add(value_beside(others_[t], tree.sums[state]))) return std::nullopt;
    }
  }
  for (int open = 0; open < beginning.open; ++open) {
    ++held;
    if (!add(not_held)) return std::nullopt;
  }
  return result;
}

DecidingEvaluator::DecidingEvaluator(const Model& model, const GraspSet& grasps, const Score& score,
                                     const std::optional<PartPrices>& prices,
                                     std::vector<Objective> wanted)
    : wanted_(with_terms(std::move(wanted), score)),
      score_(score),
      extent_(scope_for(wanted_, score)),
      scored_(contains(wanted_, Objective::score)),
      whole_(model, grasps, score, prices) {
  if (!whole_.has_hand()) extent_.hand = false;
  // A single grasp is solved as quickly as the states of a tree.
  const bool share = grasps.size() > 1 && hold_one_finger_at_most(grasps);
  const bool may_combine = are_of_strands(extent_) && share;
  if (may_combine && LoadedTrees::can_bound(model)) loaded_.emplace(model, grasps);
  if (may_combine && routings_share_states(model)) {
    whole_.share_trees();
    const Hardware hardware = possible_hardware(model);
    const double sheath = hardware.sheath.exponent();
    outliner_.emplace(grasps, std::exp(-sheath));
    greatest_exponent_ = std::max({sheath, hardware.tube.exponent(), hardware.bearing.exponent(),
                                   hardware.block.value_or(hardware.bearing).exponent()});
  }
  for (const Objective objective : wanted_) {
    if (contains(of_parts, objective)) of_parts_.push_back(objective);
  }
  estimates_ = (outliner_ || loaded_) &&
               std::all_of(wanted_.begin(), wanted_.end(), [](Objective objective) {
                 return contains(of_parts, objective) || contains(of_sums, objective);
               });
}

std::optional<Estimate> DecidingEvaluator::estimate(const RoutingBeginning& beginning) {
  if (!estimates_beginnings()) return std::nullopt;
  const bool is_whole = beginning.open == 0 && !beginning.bounds_best_alone;
  int fingers = beginning.open;
  outcome_.parts = {};
  for (const TreeOutline* tree : beginning.trees) {
    outcome_.parts += tree->parts;
    fingers += tree->fingers;
  }
  // The other trees may have tensions that leave the range of a double, but with less friction than
  // this.
  constexpr double safe = 600;
  constexpr int contacts_of_a_finger = 16;  // with the joins that lead to it
  if (!is_whole && greatest_exponent_ * contacts_of_a_finger * (fingers + 1) > safe) {
    return std::nullopt;
  }
  const std::optional<OutlinedPerformance> outlined = outliner_->at_best(beginning);
  if (!outlined) return std::nullopt;
  if (is_whole) return enclosed(*outlined, *outlined);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Estimate result = enclosed(*outlined, {{-infinity, -infinity}, {-infinity, -infinity}});
  for (const Objective objective : of_parts_) value(result.at_worst, objective) = infinity;
  return result;
}

// With the parts of the outcome.
Estimate DecidingEvaluator::enclosed(const OutlinedPerformance& at_best,
                                     const OutlinedPerformance& at_worst) const {
  Estimate result;
  compute_objectives(outcome_, of_parts_, result.at_best);
  result.at_worst = result.at_best;
  const auto put = [](ObjectiveValues& values, const OutlinedPerformance& seen, double margin) {
    value(values, Objective::uniformity_mean) = seen.mean.uniformity + margin;
    value(values, Objective::uniformity_worst) = seen.worst.uniformity + margin;
    value(values, Objective::efficiency_mean) = seen.mean.efficiency + margin;
    value(values, Objective::efficiency_worst) = seen.worst.efficiency + margin;
  };
  put(result.at_best, at_best, estimate_margin);
  put(result.at_worst, at_worst, -estimate_margin);
  return result;
}

std::optional<Estimate> DecidingEvaluator::estimate(const Routing& routing) {
  if (!estimates_ || !split_into_trees(routing, spans_)) return std::nullopt;
  if (loaded_) {
    const std::optional<LoadedBounds> bounds = loaded_->bounds(routing, spans_);
    if (!bounds) return std::nullopt;
    outcome_.parts = bounds->parts;
    return enclosed(bounds->at_best, bounds->at_worst);
  }
  beginning_.trees = whole_.shared_states().outlines(routing, spans_);
  return estimate(beginning_);
}

ObjectiveValues DecidingEvaluator::evaluate(const Routing& routing) {
  ObjectiveValues values{};
  compute_objectives(whole_.outcome(routing, extent_), wanted_, values);
  if (scored_) add_score(score_, values);
  return values;
}

ObjectiveValues DecidingEvaluator::part_values(const Routing& routing) {
  ObjectiveValues values{};
  outcome_.parts = parts(expand(routing));
  compute_objectives(outcome_, of_parts_, values);
  return values;
}

}  // namespace reeve::search
