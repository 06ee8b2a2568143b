// The parts of a routing that the wearer carries at the hand.
#pragma once

#include "core/routing.hpp"

namespace reeve::core {

struct WearerParts {
  int moving_parts = 0;  // floating blocks and bars
  int strands = 0;  // along the fingers: two of a finger that is passed, one of an anchored tip
};

WearerParts wearer_parts(const Routing& routing);

}  // namespace reeve::core
