// Lists in a sentence.
#pragma once

#include <string>
#include <vector>

#include "search/judge/objectives.hpp"

namespace reeve::pages {

// "a, b and c"
std::string enumeration(const std::vector<std::string>& items);

// "uniformity mean and sheaths"
std::string titles(const std::vector<Objective>& objectives);

}  // namespace reeve::pages
