// By what designs are ordered: front by front over the chosen objectives, within a front by a
// product or by the score (ranking.hpp).
#pragma once

#include <initializer_list>
#include <utility>
#include <vector>

#include "search/evaluate/objectives.hpp"

namespace reeve::search {

struct Order {
  std::vector<Objective> objectives{Objective::uniformity_mean, Objective::efficiency_mean};
  bool by_score = false;  // within a front

  Order() = default;
  // Objectives alone are an order.
  Order(std::vector<Objective> chosen, bool score = false)
      : objectives(std::move(chosen)), by_score(score) {}
  Order(std::initializer_list<Objective> chosen, bool score = false)
      : objectives(chosen), by_score(score) {}
};

}  // namespace reeve::search
