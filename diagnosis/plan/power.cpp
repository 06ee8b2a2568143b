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
