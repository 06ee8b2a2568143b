#include "studies/ranking_study.hpp"

#include <utility>

#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/rank/equivalent.hpp"
#include "search/rank/tradeoff.hpp"

namespace reeve::studies {
namespace {

std::vector<RankedDesign> ranked(const RankRequest& request, std::uint64_t& unconverged) {
  DesignEvaluator evaluator(request.model, request.grasps, request.score, request.prices);
  std::vector<Design> designs;
  for (const Routing& routing : request.routings) {
    designs.push_back({to_word(routing), evaluator.evaluate(routing)});
  }
  unconverged += evaluator.unconverged();
  return rank(designs, request.order);
}

std::vector<Routing> in_order(const std::vector<Routing>& routings,
                              const std::vector<RankedDesign>& designs) {
  std::vector<Routing> ordered;
  for (const RankedDesign& entry : designs) ordered.push_back(routings[entry.given]);
  return ordered;
}

Tradeoff tradeoff_of(const RankRequest& request, const std::vector<RankedDesign>& designs) {
  TradeoffArchive archive(request.order, request.tradeoff.by);
  for (const RankedDesign& entry : designs) archive.add(entry.design);
  return tradeoff(archive.candidates(), designs.front().design, request.order, request.tradeoff);
}

RankDetails details(const RankRequest& request, const std::vector<RankedDesign>& designs,
                    const std::vector<Routing>& routings, const Catalogue& catalogue) {
  RankDetails details{best_by_objective(designs, designs.size()), {}, {}};
  for (const Routing& routing : routings) {
    ShownRouting shown =
        shown_routing(routing, request.model, request.grasps, Direction::pull, catalogue);
    if (shown.hand) shown.hand->drawn = motor_force(routing, uncertainty_of(request));
    details.routings.push_back(std::move(shown));
  }
  return details;
}

}  // namespace

UncertaintyOptions uncertainty_of(const RankRequest& request) {
  const Draws draws = request.draws.value_or(Draws{});
  return {request.model, request.ranges,  request.grasps, request.order, draws.count,
          draws.seed,    request.threads, request.score,  request.prices};
}

std::optional<RankReport> ranking_study(const RankRequest& request, const Catalogue& catalogue,
                                        const StudySupervision& supervision) {
  RankReport report;
  static_cast<RankSettings&>(report) = static_cast<const RankSettings&>(request);
  const std::vector<RankedDesign> designs = ranked(request, report.unconverged);
  const std::vector<Routing> routings = in_order(request.routings, designs);
  DrawnDesigns drawn;
  if (request.draws) {
    report.uncertainty = uncertainty_of(request);
    auto designs_drawn =
        drawn_designs(routings, *report.uncertainty, supervision.during("drawing"));
    if (!designs_drawn) return std::nullopt;
    drawn = std::move(*designs_drawn);
  }
  if (request.margins) {
    MarginOptions options{request.model, request.ranges, request.grasps};
    options.threads = request.threads;
    report.margins = margins(routings, options, {{}, supervision.stop});
    if (!report.margins) return std::nullopt;
  }
  report.designs = list_designs(designs, routings, drawn, request.model, catalogue);
  // Fingers are told apart here: a finger of another number is no superfluous bearing.
  mark_equivalent(report.designs,
                  first_equivalent(designs, routings, request.order, FingerIdentity::distinct));
  mark_places(report.designs, places(designs, request.order));
  report.robust_first = robust_first(report.designs, request.order);
  report.tradeoff = list_tradeoff(tradeoff_of(request, designs), report.designs, request.order,
                                  request.model, request.prices, catalogue);
  report.motor = motor_force(routings.front(), uncertainty_of(request));
  if (request.sweep) {
    const SweepOptions options{uncertainty_of(request), request.draws.has_value(), *request.sweep};
    report.sweep = swept_designs(report.designs, options, supervision);
    if (!report.sweep) return std::nullopt;
  }
  if (request.details) report.details = details(request, designs, routings, catalogue);
  return report;
}

}  // namespace reeve::studies
