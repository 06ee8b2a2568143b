#include "studies/exploration_study.hpp"

#include <utility>

#include "catalog/names.hpp"
#include "core/canonical.hpp"

namespace reeve::studies {

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
  for (const Routing& reference : options.references) {
    report.reference_names.push_back(name_of(catalogue, reference));
  }
  report.result = std::move(result);
  return report;
}

ExploreReport exploration_study(const ExploreOptions& options,
                                const std::optional<UncertaintyOptions>& uncertainty,
                                const Catalogue& catalogue, const StudySupervision& supervision) {
  ExploreResult result = explore(options, supervision.during("exploring"));
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

}  // namespace reeve::studies
