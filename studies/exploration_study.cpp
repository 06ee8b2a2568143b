#include "studies/exploration_study.hpp"

#include <utility>

#include "catalog/names.hpp"
#include "core/canonical.hpp"
#include "search/exploration_part.hpp"

namespace reeve::studies {
namespace {

std::vector<std::string> names_of(const std::vector<Routing>& routings,
                                  const Catalogue& catalogue) {
  std::vector<std::string> names;
  for (const Routing& routing : routings) names.push_back(name_of(catalogue, routing));
  return names;
}

ExploreReport with_distributions(const ExploreOptions& options, ExploreResult result,
                                 const std::optional<UncertaintyOptions>& uncertainty,
                                 const Catalogue& catalogue, const StudySupervision& supervision) {
  std::optional<std::vector<RankDistribution>> drawn;
  const bool draws = uncertainty && !result.partial;
  if (draws) {
    drawn = rank_distributions(result.routings, *uncertainty, supervision.during("drawing"));
  }
  const bool draws_stopped = draws && !drawn;
  ExploreReport report = explore_report(options, std::move(result),
                                        drawn.value_or(std::vector<RankDistribution>{}), catalogue);
  report.uncertainty = uncertainty;
  report.draws_stopped = draws_stopped;
  return report;
}

}  // namespace

std::vector<Routing> known_routings(const GeneratorOptions& options, const Catalogue& catalogue) {
  std::vector<Routing> routings;
  for (const CatalogueEntry& entry : catalogue.entries) {
    if (finger_count(entry.routing) != options.fingers) continue;
    routings.push_back(canonical(entry.routing, options.identity));
  }
  return routings;
}

ExploreReport explore_report(const ExploreOptions& options, ExploreResult result,
                             const std::vector<RankDistribution>& distributions,
                             const Catalogue& catalogue) {
  ExploreReport report;
  report.options = options;
  report.top = list_designs(result.top, result.routings, distributions, catalogue);
  report.front = list_designs(result.front, result.routings, distributions, catalogue);
  mark_alike(report.top, options.order, options.generator.identity);
  mark_alike(report.front, options.order, options.generator.identity);
  report.ladder = list_ladder(result.ladder,
                              report.front.size() > report.top.size() ? report.front : report.top,
                              options.prices, catalogue);
  report.reference_names = names_of(options.references, catalogue);
  report.result = std::move(result);
  return report;
}

ExploreReport planned_report(const ExploreOptions& options,
                             const std::optional<UncertaintyOptions>& uncertainty,
                             const Catalogue& catalogue) {
  ExploreReport report;
  report.options = options;
  report.uncertainty = uncertainty;
  report.reference_names = names_of(options.references, catalogue);
  return report;
}

ExploreReport exploration_study(const ExploreOptions& options,
                                const std::optional<UncertaintyOptions>& uncertainty,
                                const Catalogue& catalogue, const StudySupervision& supervision) {
  return with_distributions(options, explore(options, supervision.during("exploring")), uncertainty,
                            catalogue, supervision);
}

ExploreReport merged_study(const ExploreOptions& options,
                           const std::optional<UncertaintyOptions>& uncertainty,
                           const std::vector<ShardRecord>& shards, const Catalogue& catalogue,
                           const StudySupervision& supervision) {
  return with_distributions(options, conclude(shards, options), uncertainty, catalogue,
                            supervision);
}

}  // namespace reeve::studies
