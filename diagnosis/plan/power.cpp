#include "diagnosis/plan/power.hpp"

#include <algorithm>

namespace reeve::diagnosis {
namespace {

Finding finding_of(const DiagnosisResult& result, std::vector<std::string> named,
                   std::vector<std::string> hidden) {
  std::ranges::sort(named);
  std::ranges::sort(hidden);
  switch (result.verdict) {
    case Verdict::unexplained:
      return Finding::unexplained;
    case Verdict::indistinguishable:
      return Finding::indistinguishable;
    case Verdict::none:
    case Verdict::too_few:
      return hidden.empty() ? Finding::found : Finding::none;
    case Verdict::cause:
      break;
  }
  return named == hidden ? Finding::found : Finding::wrong;
}

}  // namespace

MeasurementPlan measurement_plan(const MeasuredData& data,
                                 const std::vector<MeasurableRouting>& further,
                                 const Noise& noise) {
  MeasurementPlan plan{&data, {}, noise};
  const auto add = [&](const MeasurableRouting& routing) {
    const bool known = std::ranges::any_of(
        plan.routings, [&](const MeasurableRouting& other) { return other.word == routing.word; });
    if (!known) plan.routings.push_back(routing);
  };
  for (const MeasuredRouting& measured : data.routings) add({measured.word, measured.routing});
  for (const MeasurableRouting& routing : further) add(routing);
  return plan;
}

std::optional<PlannedMeasurement> separating_measurement(const MeasurementPlan& plan,
                                                         const std::vector<Model>& models,
                                                         const std::vector<std::string>& names) {
  for (std::size_t i = 1; i < names.size(); ++i) {
    auto found = separating_measurement(plan, models[0], names[0], models[i], names[i]);
    if (found) return found;
  }
  return std::nullopt;
}

const char* finding_name(Finding finding) {
  constexpr std::array names{"found", "wrong", "none", "unexplained", "indistinguishable"};
  return names[static_cast<std::size_t>(finding)];
}

PowerTrial judged(std::uint64_t seed, const DiagnosisResult& result,
                  const std::vector<std::string>& hidden) {
  PowerTrial trial{seed, Finding::none, {}, result.indistinguishable};
  for (const NamedCause& cause : result.causes) trial.named.push_back(cause.name);
  trial.finding = finding_of(result, trial.named, hidden);
  return trial;
}

std::vector<FindingShare> finding_shares(const std::vector<PowerTrial>& trials) {
  std::vector<FindingShare> shares;
  for (const Finding finding : findings) {
    const auto count =
        static_cast<std::size_t>(std::ranges::count(trials, finding, &PowerTrial::finding));
    const double share =
        trials.empty() ? 0 : static_cast<double>(count) / static_cast<double>(trials.size());
    shares.push_back({finding, count, share, binomial_interval(count, trials.size())});
  }
  return shares;
}

}  // namespace reeve::diagnosis
