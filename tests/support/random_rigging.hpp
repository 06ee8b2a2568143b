// Random routings with floating blocks, bars, beckets and anchored tips.
#pragma once

#include "core/routing.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve::testing {

struct RiggingRange {
  int most_fingers = 5;
  int most_blocks = 3;  // and bars
};

// Tails and passes anywhere, several passes and tails of one block, loops, joins side by side, bars
// of any ratio; only what the notation allows.
Routing random_rigging(Dice& dice, const RiggingRange& range = {});

}  // namespace reeve::testing
