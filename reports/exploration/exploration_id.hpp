// Which exploration a file is of: a hash of what was asked and of the program that answered.
//
// It is of the settings as JSON, the version, the known routings with their names, and how far it
// came if it was stopped.
#pragma once

#include <string>

#include "studies/exploration_study.hpp"

namespace reeve::reports {

std::string exploration_id(const ExploreReport& report);

// That of the whole exploration that this one is a shard of, or of itself.
std::string whole_exploration_id(const ExploreReport& report);

}  // namespace reeve::reports
