// Id of an exploration: a hash of the request and of the program that answered.
//
// It is of the settings as JSON, the version, the known routings with their names, and how far it
// came if it was stopped.
#pragma once

#include <string>

#include "studies/exploration_study.hpp"

namespace reeve::reports {

std::string exploration_id(const ExploreReport& report);

// Returns the id of the whole exploration that this one is a shard of, or its own.
std::string whole_exploration_id(const ExploreReport& report);

}  // namespace reeve::reports
