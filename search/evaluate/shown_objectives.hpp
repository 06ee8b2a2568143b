// Which objectives are shown to people: all but those that are shown on demand only, and of these
// the chosen ones, those that a constraint names, and what the score is made of where it counts.
#pragma once

#include <vector>

#include "search/evaluate/score.hpp"
#include "search/rank/ranking.hpp"

namespace reeve::search {

// In the order of their table.
std::vector<Objective> shown_objectives(const Order& order, const Score& score,
                                        const std::vector<Constraint>& constraints = {});

bool is_shown(Objective objective, const Order& order, const Score& score,
              const std::vector<Constraint>& constraints = {});

}  // namespace reeve::search
