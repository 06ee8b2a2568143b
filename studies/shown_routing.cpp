#include "studies/shown_routing.hpp"

#include "causes/model_solver.hpp"
#include "core/canonical.hpp"
#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"

namespace reeve::studies {

SolvedRouting solved_routing(const Routing& routing, const Model& model, const GraspSet& grasps,
                             Direction direction, const Catalogue& catalogue) {
  SolvedRouting report;
  report.model = model;
  report.word = to_word(routing);
  report.canonical = to_word(canonical(routing, FingerIdentity::identical));
  report.name = name_of(catalogue, routing);
  report.direction = direction;
  report.network = expand(routing);
  ModelSolver solver(model, possible_hardware(model), report.word, report.network);
  for (const WeightedGrasp& weighted : grasps) {
    const TensionState& state =
        require_in_range(solver.solve(weighted.grasp, direction, model.conditions), weighted.grasp);
    if (!solver.converged()) ++report.unconverged;
    report.grasps.push_back({weighted.grasp, state, performance(report.network, state, direction)});
  }
  return report;
}

ShownRouting shown_routing(const Routing& routing, const Model& model, const GraspSet& grasps,
                           Direction direction, const Catalogue& catalogue,
                           const std::optional<PartPrices>& prices) {
  ShownRouting report{solved_routing(routing, model, grasps, direction, catalogue)};
  report.prices = prices;
  DesignEvaluator evaluator(model, grasps, authors_score(), prices);
  report.values = evaluator.evaluate(routing);
  report.smallest_jams = evaluator.smallest_jams(routing);
  report.hand = shown_hand(report.network, report.word, report.model, grasps);
  return report;
}

}  // namespace reeve::studies
