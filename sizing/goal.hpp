// Goal of a choice of dimensions: one number of a design.
//
//   product   Π g_i, g_i objectives of which higher is better; or one objective alone
//   target    the root of Σ_g w_g Σ_f (p_gf − t_f)² / Σ_g w_g, lower is better: by how much the
//             fingers' shares p of all pull (a finger's pull is the sum of its strands) miss t
#pragma once

#include <string>
#include <vector>

#include "search/evaluate/objectives.hpp"

namespace reeve::sizing {

struct Goal {
  std::vector<Objective> factors;
  std::vector<double> target;  // shares of fingers 1 … n, which add up to 1; without factors

  bool is_target() const { return factors.empty(); }
  Better better() const;
};

// "uniformity*efficiency", "round_trip_efficiency". Throws InputError.
Goal parse_goal(const std::string& text);
// "1=0.4,2=0.2,3=0.4", "1=2,others=1": how hard the fingers are to pull, relative to each other.
// Throws InputError.
Goal parse_target(const std::string& text, int fingers);

// "uniformity_mean x efficiency_mean", "target shares 0.5, 0.25, 0.25"
std::string to_text(const Goal& goal);

}  // namespace reeve::sizing
