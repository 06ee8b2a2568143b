// A search result for some of the routings. Parts put together equal one search through all of
// them.
//
// This is exact for every cut. The keep-skyband of a union lies within the union of the skybands,
// and likewise for fronts. The lots of a sample belong to places of the whole enumeration. Counts
// add up. A part can thus be concluded alone, or after it has absorbed the others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/design_sample.hpp"
#include "search/explore.hpp"
#include "search/rank/archive.hpp"
#include "search/rank/infeasible.hpp"
#include "search/rank/tradeoff.hpp"
#include "search/shard_record.hpp"

namespace reeve::search {

struct ExplorationPart : ExplorationCounts {
  explicit ExplorationPart(const ExploreOptions& options);

  ConstraintReaches reaches;  // empty if designs are left out for their parts
  // Designs in archive and trade-off need have no values but those by which they are kept.
  Archive archive;
  TradeoffArchive tradeoff;
  DesignSample sample;
  Visited visited{};  // in this process

  // False if no design of these values can be among the best, given those there are.
  bool may_keep(const ObjectiveValues& values) const {
    return archive.may_rank(values) || tradeoff.may_be_step(values);
  }

  // Thins out the kept designs, so that they reject later designs sooner.
  void thin_out() {
    archive.members();
    tradeoff.candidates();
  }

  // Adds a disjoint part of the same exploration, of which this changes the order only.
  void absorb(ExplorationPart& other);
};

// Returns all objectives by which a routing is kept or left out.
std::vector<Objective> deciding_objectives(const ExploreOptions& options);

// Convert a part to words and back. Throws InputError on a word that is no routing of this
// exploration.
ShardRecord record_of(ExplorationPart& part);
ExplorationPart part_of(const ShardRecord& record, const ExploreOptions& options);

// Ranks what was kept, evaluates what is shown besides.
ExploreResult conclude(ExplorationPart part, const ExploreOptions& options);

// All shards of an exploration, whose options these are, each once. Throws InputError on a word
// that is no routing of theirs.
ExploreResult conclude(const std::vector<ShardRecord>& shards, const ExploreOptions& options,
                       const Supervision& supervision = {});

// Finds how near the designs come to constraints that none of them meets. If some designs were left
// out for their parts, all are evaluated again, one by one. Returns false if stopped.
bool find_reaches(ExplorationPart& part, const ExploreOptions& options,
                  const Supervision& supervision);

}  // namespace reeve::search
