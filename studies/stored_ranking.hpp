// Ranks the designs of a store again by other objectives or under other constraints, without
// evaluating anything.
//
// If a store keeps all designs, the result is that of an exploration. One that keeps the best holds
// those that fewer than K others beat in the objectives that it was made with (archive.hpp). That
// is enough
//   - for the same order, at most K designs, and the same constraints;
//   - with further constraints that each bound one of these objectives on its worse side: what
//     beats a design is no worse in it, and so meets it too; with each design that meets them those
//     that beat it meet them, and the count of these decides.
//   - for whatever is asked, where no design was left out: there are no more than it keeps.
// Otherwise a design that is asked for now may have been left out then.
#pragma once

#include <cstdint>
#include <vector>

#include "store/store_reader.hpp"
#include "studies/exploration_study.hpp"

namespace reeve::studies {

// Why designs may be missing.
enum class Gap : std::uint8_t {
  other_order,           // other objectives, or another score that decides
  constraint_dropped,    // the designs that it left out were not kept
  constraint_elsewhere,  // its objective is not ranked, or bounded on the better side
  more_than_kept,        // designs
};

// Returns the gaps of a store that keeps the best alone, as far as options tell. Empty if there are
// none.
std::vector<Gap> gaps(const ExploreOptions& stored, const ExploreOptions& asked);

struct StoredRanking {
  ExploreReport report;  // report of the kept designs; without known routings and sample
  std::vector<Gap> gaps;
  std::uint64_t kept = 0;    // designs that were ranked or failed a constraint
  std::uint64_t failed = 0;  // kept designs that failed a constraint
  // Not every shard was explored to its end.
  bool partial = false;
  std::uint64_t shards = 0;  // shards that have begun
  std::uint64_t of_shards = 1;
};

// The options: as the store was made, and as they are asked for.
StoredRanking stored_ranking(const StoreReader& store, const ExploreOptions& stored,
                             ExploreOptions asked, const Catalogue& catalogue);

}  // namespace reeve::studies
