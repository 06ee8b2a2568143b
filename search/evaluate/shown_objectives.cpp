#include "search/evaluate/shown_objectives.hpp"

#include <algorithm>

namespace reeve::search {
namespace {

bool is_chosen(Objective objective, const Order& order) {
  const auto& chosen = order.objectives;
  return std::find(chosen.begin(), chosen.end(), objective) != chosen.end();
}

bool is_constrained(Objective objective, const std::vector<Constraint>& constraints) {
  return std::any_of(constraints.begin(), constraints.end(), [&](const Constraint& constraint) {
    return constraint.objective == objective;
  });
}

}  // namespace

bool is_shown(Objective objective, const Order& order, const Score& score,
              const std::vector<Constraint>& constraints) {
  if (!row(objective).on_demand || is_chosen(objective, order)) return true;
  if (is_constrained(objective, constraints)) return true;
  if (!order.by_score && !is_chosen(Objective::score, order)) return false;
  return objective == Objective::score ||
         std::any_of(score.terms.begin(), score.terms.end(),
                     [&](const ScoreTerm& term) { return term.objective == objective; });
}

bool is_answered(Objective objective, const Order& order, const Score& score,
                 const std::vector<Constraint>& constraints) {
  return objective == Objective::motor_force || is_shown(objective, order, score, constraints);
}

std::vector<Objective> shown_objectives(const Order& order, const Score& score,
                                        const std::vector<Constraint>& constraints) {
  std::vector<Objective> shown;
  for (const ObjectiveRow& row : objective_table()) {
    if (is_shown(row.objective, order, score, constraints)) shown.push_back(row.objective);
  }
  return shown;
}

}  // namespace reeve::search
