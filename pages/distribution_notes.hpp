// What stands below the tension distributions: where published values come from, and what is wrong
// with them or with the data.
#pragma once

#include <string>

#include "studies/tension_distributions.hpp"

namespace reeve::pages {

// HTML: which published values the check finds at fault and why, what was left out of the data.
std::string distribution_notes(const TensionDistributions& distributions);

}  // namespace reeve::pages
