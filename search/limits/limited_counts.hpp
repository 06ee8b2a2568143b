// Numbers of routings that hang on the motor and meet constraints on their parts. Computed by
// formula from the classes of parts (part_classes.hpp) of tendons and trees.
#pragma once

#include <cstdint>
#include <vector>

#include "search/enumerate/generator.hpp"
#include "search/evaluate/objectives.hpp"

namespace reeve::search {

struct LimitedCounts {
  std::uint64_t meeting = 0;     // all constraints
  std::uint64_t one_tendon = 0;  // … with a single tendon, or tree of tendons
  // Parallel to the constraints: those that each is the first to reject.
  std::vector<std::uint64_t> rejected;
};

// Throws InputError of a constraint that parts do not decide, of more sums of parts than classes
// hold, and where fingers are told apart.
LimitedCounts count_limited(const GeneratorOptions& options,
                            const std::vector<Constraint>& constraints);

}  // namespace reeve::search
