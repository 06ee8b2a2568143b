// What a store says of the exploration that it is of.
#pragma once

#include <string>
#include <vector>

#include "store/description.hpp"
#include "studies/exploration_study.hpp"

namespace reeve::reports {

// Of a report that is planned; the arguments are those of the command, but for where and which
// shard.
Description store_description(const ExploreReport& planned,
                              const std::vector<std::string>& arguments);

}  // namespace reeve::reports
