#include "search/judge/shown_objectives.hpp"

#include <algorithm>

namespace reeve::search {
namespace {

bool is_chosen(Objective objective, const Order& order) {
  const auto& chosen = order.objectives;
  return std::find(chosen.begin(), chosen.end(), objective) != chosen.end();
}

}  // namespace

bool is_shown(Objective objective, const Order& order, const Score& score) {
  if (!row(objective).on_demand || is_chosen(objective, order)) return true;
  if (!order.by_score && !is_chosen(Objective::score, order)) return false;
  return objective == Objective::score ||
         std::any_of(score.terms.begin(), score.terms.end(),
                     [&](const ScoreTerm& term) { return term.objective == objective; });
}

std::vector<Objective> shown_objectives(const Order& order, const Score& score) {
  std::vector<Objective> shown;
  for (const ObjectiveRow& row : objective_table()) {
    if (is_shown(row.objective, order, score)) shown.push_back(row.objective);
  }
  return shown;
}

}  // namespace reeve::search
