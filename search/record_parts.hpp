// What a record (shard_record.hpp) says, as an exploration has it, but for values of its designs.
#pragma once

#include <string>
#include <vector>

#include "search/exploration_part.hpp"

namespace reeve::search {

// Throw InputError on a word that is no routing of this exploration.
std::vector<Routing> generated_routings(const std::vector<std::string>& words,
                                        const ExploreOptions& options);
// Counts and sample.
ExplorationPart counted_part(const ShardRecord& record, const ExploreOptions& options);

std::vector<std::string> archived_words(const ShardRecord& record);

}  // namespace reeve::search
