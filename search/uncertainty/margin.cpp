#include "search/uncertainty/margin.hpp"

#include <functional>

#include "core/notation.hpp"
#include "numerics/minimise.hpp"
#include "numerics/parallel.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/uncertainty/coefficient_box.hpp"

namespace reeve::search {
namespace {

double product(const Routing& routing, const Model& model, const GraspSet& grasps) {
  const EvaluationScope of_product{false, false, false, false, false};
  return uniformity_times_efficiency(DesignEvaluator(model, grasps).evaluate(routing, of_product));
}

// The corners of the box, to which leads often fall, and the nominal coefficients, which no least
// lead may be above.
std::vector<std::vector<double>> starts(const std::vector<Interval>& box, const Hardware& nominal) {
  std::vector<std::vector<double>> points{point_of(nominal)};
  for (std::size_t corner = 0; corner < std::size_t{1} << box.size(); ++corner) {
    std::vector<double>& point = points.emplace_back();
    for (std::size_t i = 0; i < box.size(); ++i) {
      point.push_back((corner >> i & 1U) != 0 ? box[i].high : box[i].low);
    }
  }
  return points;
}

Minimum least_of(const std::function<double(const std::vector<double>&)>& function,
                 const std::vector<std::vector<double>>& points) {
  Minimum least{points.front(), function(points.front())};
  for (const std::vector<double>& point : points) {
    const double value = function(point);
    if (value < least.value) least = {point, value};
  }
  return least;
}

Margin margin(const Routing& first, const Routing& challenger, const MarginOptions& options) {
  const auto lead = [&](const Model& model) {
    return product(first, model, options.grasps) - product(challenger, model, options.grasps);
  };
  const CoefficientBox box = coefficient_box(options.nominal.hardware, options.ranges);
  const std::vector<Interval> intervals(box.begin(), box.end());
  const auto lead_at = [&](const std::vector<double>& point) {
    return lead(at_point(options.nominal, point));
  };
  Minimum least = minimise(lead_at, intervals, options.evaluations);
  const Minimum corner = least_of(lead_at, starts(intervals, options.nominal.hardware));
  const Minimum beside = descend(lead_at, intervals, corner.at, options.evaluations);
  if (beside.value < least.value) least = beside;
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
