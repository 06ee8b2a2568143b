// What somebody keeps of an exploration while it runs, so that a later one can go on from there.
//
// An exploration goes through its routings in one order, so that all of it is told by how far it
// came and by the part that it has kept until there (exploration_part.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "search/evaluate/objectives.hpp"
#include "search/shard_record.hpp"

namespace reeve::search {

struct ExplorationPart;

// A design that was evaluated in full, whether or not it meets the constraints.
struct EvaluatedDesign {
  std::uint64_t place = 0;  // in the whole enumeration
  std::string word;
  ObjectiveValues values{};
};

// All may be empty; `is_due` and `save` go together.
struct Checkpoint {
  // Of the same exploration and shard, where it goes on.
  std::optional<ShardRecord> before{};
  // Every design, in the order of the places; each is then evaluated in full.
  std::function<void(const EvaluatedDesign&)> design{};
  // Asked now and then. When it is, and at the end, what there is of the exploration is saved: all
  // designs given so far are in it. The part stays as it is but for its order.
  std::function<bool()> is_due{};
  std::function<void(ExplorationPart&)> save{};
};

}  // namespace reeve::search
