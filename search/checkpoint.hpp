// Saved state of a running exploration, from which a later run can continue.
//
// An exploration goes through its routings in one order. Its state is therefore the number of
// routings done and the part kept so far (exploration_part.hpp).
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
  std::uint64_t place = 0;  // place in the whole enumeration
  std::string word;
  ObjectiveValues values{};
};

// All may be empty; `is_due` and `save` go together.
struct Checkpoint {
  // The record to continue from, of the same exploration and shard.
  std::optional<ShardRecord> before{};
  // Receives every design, in the order of the places. Each is then evaluated in full.
  std::function<void(const EvaluatedDesign&)> design{};
  // Asked now and then. If it is due, and at the end, the state of the exploration is saved, with
  // all designs given so far. Saving changes only the order within the part.
  std::function<bool()> is_due{};
  std::function<void(ExplorationPart&)> save{};
};

}  // namespace reeve::search
