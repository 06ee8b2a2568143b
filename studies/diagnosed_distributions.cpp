#include "studies/diagnosed_distributions.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "readings/measured_shares.hpp"

namespace reeve::studies {
namespace {

std::vector<Routing> routings_with_shares(const MeasuredData& data) {
  std::vector<Routing> routings;
  std::vector<std::size_t> seen;
  for (const MeasuredShares& group : measured_shares(data).groups) {
    const Routing& routing = data.routings[group.routing].routing;
    if (std::find(seen.begin(), seen.end(), group.routing) != seen.end()) continue;
    seen.push_back(group.routing);
    if (routings.empty() || finger_count(routing) == finger_count(routings.front())) {
      routings.push_back(routing);
    }
  }
  return routings;
}

bool has_coefficient(const Hardware& hardware, double mu) {
  return hardware.tube.mu == mu && hardware.sheath.mu == mu;
}

std::vector<FrictionCase> cases(const Hardware& hardware, const DiagnosisResult& result,
                                const std::vector<PublishedModel>& published) {
  const Model standing{hardware, {}, result.model.conditions};
  std::vector<FrictionCase> list;
  const bool stands_among_them =
      std::any_of(published.begin(), published.end(),
                  [&](const PublishedModel& model) { return has_coefficient(hardware, model.mu); });
  if (!stands_among_them) list.push_back({FrictionKind::model, standing});
  for (const PublishedModel& model : published) {
    const bool is_there = std::any_of(list.begin(), list.end(), [&](const FrictionCase& which) {
      return has_coefficient(which.model.hardware, model.mu);
    });
    if (!is_there) list.push_back(with_coefficient(standing, model.mu));
  }
  if (!result.model.effects.empty()) list.push_back({FrictionKind::diagnosed, result.model});
  return list;
}

}  // namespace

std::optional<TensionDistributions> diagnosed_distributions(
    const MeasuredData& data, const Hardware& hardware, const DiagnosisResult& result,
    const std::vector<PublishedModel>& published, const Catalogue& catalogue) {
  DistributionRequest request{routings_with_shares(data), cases(hardware, result, published), data};
  if (request.routings.empty()) return std::nullopt;
  try {
    return measured_distributions(request, catalogue);
  } catch (const OutOfRange&) {
    return std::nullopt;
  }
}

}  // namespace reeve::studies
