// What the files of a shard must hold, so that shards can be put together exactly: routings as
// words and what was counted. Values are worked out again from the words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "search/rank/infeasible.hpp"

namespace reeve::search {

// How the generated designs stand to a reference.
struct ReferenceCount {
  std::uint64_t dominated_by = 0;
  bool generated = false;
  std::optional<std::size_t> rejected_by;
};

struct ArchivedWord {
  std::string word;
  std::uint64_t equals_left_out = 0;  // see archive.hpp
};

struct SampledWord {
  std::uint64_t place = 0;  // in the whole enumeration
  std::string word;
};

struct ExplorationCounts {
  std::uint64_t total = 0;
  std::uint64_t generated = 0;
  std::uint64_t evaluated = 0;
  std::uint64_t unconverged = 0;  // tension solves that decide what is kept
  double seconds = 0;
  std::vector<std::uint64_t> constraint_failures{};  // parallel to the constraints
  std::vector<ReferenceCount> references{};          // parallel to those of the options
};

struct ShardRecord : ExplorationCounts {
  std::vector<ConstraintReach> reaches;  // parallel to the constraints
  std::vector<ArchivedWord> archive;
  std::vector<std::string> rungs;  // candidates of the ladder
  std::vector<SampledWord> sample;
  std::string origin{};  // the file that it was read from, for messages
};

}  // namespace reeve::search
