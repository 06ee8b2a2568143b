// The search through routings: those of a shard at once, or in pieces, for several that share it
// (studies/ranks.hpp).
//
// Routings are generated in order, a batch while the one before is evaluated slot by slot, and
// offered to what is kept in order, so that the number of threads changes nothing.
//
// Pieces are cut anywhere, as shards are (exploration_part.hpp). Whoever goes through several of
// them, each behind the one before, knows designs of those before, so that soon few of a piece are
// left that can be among the best of all: what it brings of a piece is short. Left out are designs
// that enough designs of lower places dominate; so the pieces from the first to any one, put
// together, give the part of the whole up to there.
#pragma once

#include <cstdint>
#include <functional>

#include "search/enumerate/generator.hpp"
#include "search/exploration_part.hpp"

namespace reeve::search {

// that_may_be_kept: designs that constraints reject for their parts alone are left out.
// all: every design is evaluated, to find how near it comes to the constraints.
enum class EvaluatedDesigns : std::uint8_t { that_may_be_kept, all };

ExplorationPart search_batches(const ExploreOptions& options, const Checkpoint& checkpoint,
                               EvaluatedDesigns evaluated, const Supervision& supervision);

// Goes through the routings at these places of the enumeration, and keeps the memory of pieces
// before.
using PieceSearch = std::function<ExplorationPart(const ShardRange&, const Supervision&)>;
PieceSearch piece_search(const ExploreOptions& options);

// Puts one record after the other to what there is, in the order of their places. Designs that
// enough of what there is dominate are left out; the others have the values by which they are kept,
// or all of them.
using RecordAbsorbing = std::function<void(ExplorationPart&, const ShardRecord&)>;
RecordAbsorbing record_absorbing(const ExploreOptions& options, bool with_all_values);

}  // namespace reeve::search
