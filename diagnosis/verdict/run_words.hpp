// Runs in words.
#pragma once

#include <string>
#include <vector>

#include "readings/measured_data.hpp"

namespace reeve::diagnosis {

// "A, B and C".
std::string listed(const std::vector<std::string>& names);

// "run m3", "runs m8 to m12", "runs m1, m3 and m4", "all runs"; and of names that say it
// themselves "run 5 and run 11". Ascending, at least one.
std::string runs_text(const std::vector<std::size_t>& runs, const MeasuredData& data);

}  // namespace reeve::diagnosis
