// Objectives shown to people: all that are not marked on demand, the chosen ones, those that a
// constraint names, and the terms of the score if it counts.
#pragma once

#include <vector>

#include "search/evaluate/score.hpp"
#include "search/rank/ranking.hpp"

namespace reeve::search {

// Returns them in the order of their table.
std::vector<Objective> shown_objectives(const Order& order, const Score& score,
                                        const std::vector<Constraint>& constraints = {});

// The objectives of which an answer names the best design: those shown, and the motor force, which
// it gives of every hand.
bool is_answered(Objective objective, const Order& order, const Score& score,
                 const std::vector<Constraint>& constraints = {});

bool is_shown(Objective objective, const Order& order, const Score& score,
              const std::vector<Constraint>& constraints = {});

}  // namespace reeve::search
