// An exploration that is kept in a store while it runs.
#pragma once

#include <chrono>

#include "search/checkpoint.hpp"
#include "store/exploration_store.hpp"

namespace reeve::studies {

// Goes on where the store ends; saves when so long has passed since the last time, or when many
// designs have gathered. The store has to outlive it.
Checkpoint checkpoint_in(ExplorationStore& store, std::chrono::seconds every);

}  // namespace reeve::studies
