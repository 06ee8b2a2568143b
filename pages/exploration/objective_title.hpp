// Objectives by the names that pages give them.
#pragma once

#include <string>
#include <vector>

#include "search/evaluate/objectives.hpp"

namespace reeve::pages {

// "uniformity mean"
std::string objective_title(const ObjectiveRow& row);
// "uniformity mean, efficiency mean"
std::string objective_titles(const std::vector<Objective>& objectives);

}  // namespace reeve::pages
