// The same counts as counting.hpp, from the definition of a routing and no formula: every
// assignment of parts is written down as a coloured graph, and isomorphism classes are counted.
#pragma once

#include <cstdint>

#include "tests/support/counting.hpp"

namespace reeve::testing {

struct BruteForceCounts {
  std::uint64_t all = 0;
  std::uint64_t actuated = 0;
  std::uint64_t one_tendon = 0;
};

// Meant for up to 3 fingers: the assignments grow faster than factorially.
// Throws std::invalid_argument on a negative number of kinds or fingers < 1.
BruteForceCounts brute_force_counts(const CountedParts& parts, int fingers, bool identical_fingers);

}  // namespace reeve::testing
