// Counts and lists in a sentence.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "search/judge/objectives.hpp"

namespace reeve::pages {

// "1 sheath", "2 sheaths"
std::string plural(std::uint64_t count, const std::string& noun);

// "a, b and c"
std::string enumeration(const std::vector<std::string>& items);

// "uniformity mean and sheaths"
std::string titles(const std::vector<Objective>& objectives);

}  // namespace reeve::pages
