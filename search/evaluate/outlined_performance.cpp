#include "search/evaluate/outlined_performance.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace reeve::search {
namespace {

using Value = std::optional<OutlinedValue>;

Value value_of(bool in_range, double motor, const StrandTally& strands) {
  if (!in_range || !std::isnormal(motor) || !(strands.most > 0)) return std::nullopt;
  return OutlinedValue{strands.least / strands.most, strands.work / motor};
}

Value value_of(const TreeSums& moving, const TreeSums& jammed) {
  if (!jammed.jams) return value_of(moving.in_range, moving.motor, moving.strands);
  Value value = value_of(moving.in_range && jammed.in_range, jammed.motor, jammed.strands);
  if (!value) return value;
  value->efficiency = 0;
  if (moving.has_strands()) value->uniformity = 0;
  return value;
}

// As with others += state, without keeping the sum.
Value value_beside(const TreeSums& others, const TreeSums& state) {
  if (state.jams) return value_of(others, state);
  StrandTally strands;
  strands.least = std::min(others.strands.least, state.strands.least);
  strands.most = std::max(others.strands.most, state.strands.most);
  strands.work = others.strands.work + state.strands.work;
  return value_of(others.in_range && state.in_range, others.motor + state.motor, strands);
}

Value value_held(std::size_t held, const std::vector<TreeSpan>& spans,
                 const std::vector<const TreeOutline*>& trees) {
  TreeSums moving;
  TreeSums jammed;
  for (std::size_t t = 0; t < spans.size(); ++t) {
    const auto before = static_cast<std::size_t>(spans[t].fingers_before);
    const bool is_its_own = held > before && held < before + trees[t]->sums.size();
    const TreeSums& sums = trees[t]->sums[is_its_own ? held - before : 0];
    (sums.jams ? jammed : moving) += sums;
  }
  return value_of(moving, jammed);
}

void add_value(double share, const OutlinedValue& value, OutlinedPerformance& sum) {
  sum.mean.uniformity += share * value.uniformity;
  sum.mean.efficiency += share * value.efficiency;
  sum.worst.uniformity = std::min(sum.worst.uniformity, value.uniformity);
  sum.worst.efficiency = std::min(sum.worst.efficiency, value.efficiency);
}

}  // namespace

PerformanceOutliner::PerformanceOutliner(const GraspSet& grasps) : weights_(max_fingers + 1) {
  double all = 0;
  for (const WeightedGrasp& grasp : grasps) all += grasp.weight;
  for (const WeightedGrasp& grasp : grasps) {
    const std::uint64_t held = grasp.grasp.held;
    Weight& weight = weights_[held == 0 ? 0 : static_cast<std::size_t>(std::countr_zero(held)) + 1];
    weight.is_asked = true;
    weight.share += grasp.weight / all;
  }
}

bool PerformanceOutliner::add_up_others(const std::vector<const TreeOutline*>& trees) {
  others_.assign(trees.size(), TreeSums{});
  TreeSums before;
  for (std::size_t t = 0; t < trees.size(); ++t) {
    others_[t] = before;
    before += trees[t]->sums[0];
  }
  TreeSums behind;
  for (std::size_t t = trees.size(); t-- > 0;) {
    others_[t] += behind;
    behind += trees[t]->sums[0];
  }
  return !behind.jams;
}

std::optional<OutlinedPerformance> PerformanceOutliner::outlined(
    const std::vector<TreeSpan>& spans, const std::vector<const TreeOutline*>& trees) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  OutlinedPerformance result{{0, 0}, {infinity, infinity}};
  const bool moves = add_up_others(trees);
  const auto add_state = [&](std::size_t t, std::size_t state) {
    const auto before = static_cast<std::size_t>(spans[t].fingers_before);
    const std::size_t held = state == 0 ? 0 : before + state;
    if (!weights_[held].is_asked) return true;
    const Value value =
        moves ? value_beside(others_[t], trees[t]->sums[state]) : value_held(held, spans, trees);
    if (value) add_value(weights_[held].share, *value, result);
    return value.has_value();
  };
  if (!add_state(0, 0)) return std::nullopt;
  for (std::size_t t = 0; t < trees.size(); ++t) {
    for (std::size_t state = 1; state < trees[t]->sums.size(); ++state) {
      if (!add_state(t, state)) return std::nullopt;
    }
  }
  return result;
}

}  // namespace reeve::search
