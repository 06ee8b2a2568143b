#include "diagnosis/verdict/group_estimates.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/fit/fit.hpp"
#include "numerics/student_t.hpp"

namespace reeve::diagnosis {
namespace {

// Share of the searched range: with a greater standard error the value is unknown.
constexpr double unknown_share = 1.0 / 6;

// Parallel to the effects: nothing of those that the group hardly tells.
using OfGroup = std::vector<std::optional<GroupEstimate>>;

OfGroup estimates_of(const MeasuredData& data, std::size_t group,
                     const std::vector<std::size_t>& readings, const Model& model,
                     const Scatter& scatter, double mounting_degrees, Workers& workers) {
  OfGroup result(model.effects.size());
  const Dataset own = dataset(data, readings);
  if (own.degrees_of_freedom() <= static_cast<double>(parameter_count(model))) return result;
  if (!try_forecast(own, model)) return result;
  const Problem known = problem(own, scatter, model, workers);
  const Model fitted = fit(known, model).model;
  const auto intervals = parameter_intervals(known, fitted, mounting_degrees);
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    const auto parameters =
        searched_parameters(*model.effects[e].cause, model.hardware, known.force_scale);
    if (parameters.empty()) continue;
    const Range range = parameters.front().range;
    const ParameterInterval& interval = intervals[e].front();
    if (!(interval.deviation <= unknown_share * (range.high - range.low))) continue;
    result[e] = GroupEstimate{group, fitted.effects[e].values.front(), interval};
  }
  return result;
}

// Two-sided, of one group beside all others.
double chance_of(const EstimatesByGroup& all, const GroupEstimate& one) {
  double weight = 0;
  double weighed = 0;
  double degrees = one.interval.degrees;
  for (const GroupEstimate& other : all.groups) {
    if (other.group == one.group) continue;
    const double of = std::pow(other.interval.deviation, -2);
    weight += of;
    weighed += of * other.value;
    degrees = std::min(degrees, other.interval.degrees);
  }
  const double own = std::pow(one.interval.deviation, 2);
  const double others = 1 / weight;
  const double off = std::abs(one.value - weighed / weight) / std::sqrt(own + others);
  const double welch =
      std::pow(own + others, 2) / (own * own / one.interval.degrees + others * others / degrees);
  return two_sided_p_value(off, welch);
}

// Two groups are one comparison.
std::size_t comparisons(const std::vector<EstimatesByGroup>& all) {
  std::size_t count = 0;
  for (const EstimatesByGroup& one : all) count += one.groups.size() == 2 ? 1 : one.groups.size();
  return count;
}

void compare(EstimatesByGroup& estimates, std::size_t comparisons, double alpha) {
  double least = 2;
  for (const GroupEstimate& one : estimates.groups) {
    const double chance = chance_of(estimates, one);
    if (chance >= least) continue;
    least = chance;
    estimates.farthest = one.group;
  }
  estimates.p_value = std::min(1.0, least * static_cast<double>(comparisons));
  estimates.differs = estimates.p_value < alpha;
}

}  // namespace

std::vector<EstimatesByGroup> estimates_by_group(const MeasuredData& data,
                                                 const std::vector<std::size_t>& readings,
                                                 const Model& model, const Scatter& scatter,
                                                 double mounting_degrees, double alpha,
                                                 Workers& workers) {
  const std::size_t groups = data.groups.size();
  if (groups < 2 || groups > most_groups_estimated || model.effects.empty()) return {};
  std::vector<std::vector<std::size_t>> own(groups);
  for (const std::size_t i : readings) {
    if (const auto group = data.readings[i].group) own[*group].push_back(i);
  }
  std::vector<EstimatesByGroup> result;
  for (const Effect& effect : model.effects) {
    const auto parameters = effect.cause->parameters(model.hardware);
    if (parameters.empty()) {
      result.push_back({effect_name(effect), "", "", {}});
    } else {
      result.push_back({effect_name(effect), parameters.front().name, parameters.front().unit, {}});
    }
  }
  for (std::size_t g = 0; g < groups; ++g) {
    const OfGroup found = estimates_of(data, g, own[g], model, scatter, mounting_degrees, workers);
    for (std::size_t e = 0; e < found.size(); ++e) {
      if (found[e]) result[e].groups.push_back(*found[e]);
    }
  }
  std::erase_if(result, [](const EstimatesByGroup& one) { return one.groups.size() < 2; });
  const std::size_t all = comparisons(result);
  for (EstimatesByGroup& one : result) compare(one, all, alpha);
  return result;
}

}  // namespace reeve::diagnosis
