// Content of a shard's files: routings as words, and counts. Shards can be put together exactly
// from it; values are evaluated again from the words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "search/rank/infeasible.hpp"

namespace reeve::search {

// Relation of the generated designs to a reference.
struct ReferenceCount {
  std::uint64_t dominated_by = 0;
  bool generated = false;
  std::optional<std::size_t> rejected_by;
};

// Designs that have no tensions in one of the grasps: counted, and left out.
struct WithoutTensions {
  std::uint64_t count = 0;
  std::string example{};  // the shortest word, of these the first by letters

  void add(const WithoutTensions& other);
};

struct ArchivedWord {
  std::string word;
  std::uint64_t equals_left_out = 0;  // see archive.hpp
};

struct SampledWord {
  std::uint64_t place = 0;  // place in the whole enumeration
  std::string word;
};

struct ExplorationCounts {
  std::uint64_t total = 0;
  std::uint64_t generated = 0;
  std::uint64_t evaluated = 0;
  WithoutTensions without_tensions{};
  std::uint64_t unconverged = 0;  // tension solves that decide what is kept
  double seconds = 0;
  std::vector<std::uint64_t> constraint_failures{};  // parallel to the constraints
  std::vector<ReferenceCount> references{};          // parallel to those of the options
};

struct ShardRecord : ExplorationCounts {
  std::vector<ConstraintReach> reaches;  // parallel to the constraints
  std::vector<ArchivedWord> archive;
  std::vector<std::string> steps;  // candidates of the trade-off
  std::vector<SampledWord> sample;
  std::string origin{};  // the file that it was read from, for messages
};

}  // namespace reeve::search
