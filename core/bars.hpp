// Rigid bars in place of floating blocks: a bar that tendons are tied to has no friction.
#pragma once

#include <optional>
#include <vector>

#include "core/routing.hpp"

namespace reeve::core {

// Returns the same routing with an even bar in place of each block, numbered alike. Returns nothing
// if the routing has bars already, or no block, or a block that one tendon does not pass exactly
// once.
std::optional<Routing> with_bars(const Routing& routing);

// Returns a whiffletree: a chain of bars that pulls fingers 1 … n, tied at their tips, in this
// ratio. Returns nothing for one finger, for more bars than a routing can have, or for arms beyond
// those of a word.
std::optional<Routing> whiffletree(const std::vector<double>& pulls);

}  // namespace reeve::core
