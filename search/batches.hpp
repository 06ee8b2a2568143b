// The search through the routings of a shard: generated in order, a batch while the one before is
// evaluated slot by slot, and offered to what is kept in order, so that the number of threads
// changes nothing.
#pragma once

#include <cstdint>

#include "search/exploration_part.hpp"

namespace reeve::search {

// Whether designs are left out that constraints reject for their parts alone, or all are looked at
// to say how near they come.
enum class EvaluatedDesigns : std::uint8_t { that_may_be_kept, all };

ExplorationPart search_batches(const ExploreOptions& options, const Checkpoint& checkpoint,
                               EvaluatedDesigns evaluated, const Supervision& supervision);

}  // namespace reeve::search
