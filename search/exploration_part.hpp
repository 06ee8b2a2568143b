// What a search through some of the routings keeps of them, such that parts of an enumeration can
// be put together to what a search through all of it would have kept.
//
// Exact, whatever the cut: the keep-skyband of a union is within the union of the skybands, as a
// front within that of the fronts; the lots of a sample belong to places of the whole enumeration;
// counts add up. So a part is concluded alone, or after it has absorbed the others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/routing.hpp"
#include "search/explore.hpp"
#include "search/rank/archive.hpp"
#include "search/rank/infeasible.hpp"
#include "search/rank/ladder.hpp"
#include "search/shard_record.hpp"

namespace reeve::search {

// A random sample out of a stream of any length: those few whose random numbers are the least.
//
// Each routing's number is a function of its place in the whole enumeration, so the sample is the
// same for any number of threads, and those of all shards together hold the sample of the whole.
struct SampledRouting {
  std::uint64_t place = 0;
  Routing routing;
};

class DesignSample {
 public:
  explicit DesignSample(std::size_t size) : size_(size) {}

  // Whether the routing at this place of the enumeration would enter now; may be asked from many
  // threads.
  bool would_enter(std::uint64_t place) const;

  void add(std::uint64_t place, const Routing& routing);

  // Both in the order of their places.
  std::vector<SampledRouting> members() const;
  std::vector<Routing> routings() const;

 private:
  struct Member {
    double lot = 0;
    std::uint64_t place = 0;
    Routing routing;

    bool operator<(const Member& other) const { return lot < other.lot; }
  };

  std::size_t size_;
  std::vector<Member> members_;  // a heap: the greatest lot first
};

struct ExplorationPart : ExplorationCounts {
  explicit ExplorationPart(const ExploreOptions& options);

  ConstraintReaches reaches;  // of no constraint where designs are left out for their parts
  // Designs in archive and ladder need have no values but those by which they are kept.
  Archive archive;
  LadderArchive ladder;
  DesignSample sample;

  // Of the same exploration, and disjoint.
  void absorb(ExplorationPart other);
};

// All that a routing is kept or left for.
std::vector<Objective> deciding_objectives(const ExploreOptions& options);

// As words, and back. Throws InputError on a word that is no routing of this exploration.
ShardRecord record_of(ExplorationPart& part);
ExplorationPart part_of(const ShardRecord& record, const ExploreOptions& options);

// Ranks what was kept, evaluates what is shown besides.
ExploreResult conclude(ExplorationPart part, const ExploreOptions& options);

// All shards of an exploration, whose options these are, each once. Throws InputError on a word
// that is no routing of theirs.
ExploreResult conclude(const std::vector<ShardRecord>& shards, const ExploreOptions& options,
                       const Supervision& supervision = {});

// How near the designs come to constraints that none of them meets: where some were left out for
// their parts, all are looked at again, one by one. False if that was stopped.
bool find_reaches(ExplorationPart& part, const ExploreOptions& options,
                  const Supervision& supervision);

}  // namespace reeve::search
