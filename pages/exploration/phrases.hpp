// Lists in a sentence.
#pragma once

#include <string>
#include <vector>

#include "search/evaluate/objectives.hpp"

namespace reeve::pages {

// "a, b and c"
std::string enumeration(const std::vector<std::string>& items);

// "0.9958"; "-" of what there is none of, as in the terminal.
std::string four_digits(double value);

// "uniformity mean and sheaths"
std::string titles(const std::vector<Objective>& objectives);

}  // namespace reeve::pages
