// The search through the routings of a shard: generated in order, a batch while the one before is
// evaluated slot by slot, and offered to what is kept in order, so that the number of threads
// changes nothing.
#pragma once

#include <cstdint>

#include "search/exploration_part.hpp"

namespace reeve::search {

// Whether designs are left out that constraints reject for their parts alone, or all are looked at
// to say how near they come.
enum class Look : std::uint8_t { at_what_may_be_kept, at_all };

ExplorationPart search_batches(const ExploreOptions& options, const Keeping& keeping, Look look,
                               const Supervision& supervision);

}  // namespace reeve::search
