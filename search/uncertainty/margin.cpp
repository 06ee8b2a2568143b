#include "search/uncertainty/margin.hpp"

#include "core/notation.hpp"
#include "numerics/minimise.hpp"
#include "numerics/parallel.hpp"
#include "search/judge/evaluation.hpp"
#include "search/uncertainty/coefficient_box.hpp"

namespace reeve::search {
namespace {

double product(const Routing& routing, const Model& model, const GraspSet& grasps) {
  return uniformity_times_efficiency(DesignEvaluator(model, grasps).evaluate(routing));
}

Margin margin(const Routing& first, const Routing& challenger, const MarginOptions& options) {
  const auto lead = [&](const Model& model) {
    return product(first, model, options.grasps) - product(challenger, model, options.grasps);
  };
  const CoefficientBox box = coefficient_box(options.nominal.hardware, options.ranges);
  const std::vector<Interval> intervals(box.begin(), box.end());
  const Minimum least = minimise(
      [&](const std::vector<double>& point) { return lead(at_point(options.nominal, point)); },
      intervals, options.evaluations);
  return {to_word(challenger), lead(options.nominal), least.value,
          effective_hardware(at_point(options.nominal, least.at))};
}

}  // namespace

std::optional<std::vector<Margin>> margins(const std::vector<Routing>& ranked,
                                           const MarginOptions& options,
                                           const Supervision& supervision) {
  const auto stopped = [&] { return supervision.stop != nullptr && supervision.stop->load(); };
  if (ranked.empty()) return std::vector<Margin>{};
  std::vector<Margin> result(ranked.size() - 1);
  Workers(options.threads).for_each_block(result.size(), 1, [&](const IndexBlock& block) {
    for (std::size_t i = block.begin; i < block.end && !stopped(); ++i) {
      result[i] = margin(ranked.front(), ranked[i + 1], options);
    }
  });
  if (stopped()) return std::nullopt;
  return result;
}

}  // namespace reeve::search
