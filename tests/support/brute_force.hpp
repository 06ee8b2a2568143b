// The same counts as counting.hpp, from the definition of what is generated and no formula.
//
// Every way to tie strands, the two sides of each block's pass and each block's tail to each other
// and to ends is tried; what breaks a rule is thrown away, the rest is written down as a coloured
// graph, and isomorphism classes are counted.
#pragma once

#include "tests/support/counting.hpp"

namespace reeve::testing {

// Meant for up to 3 fingers and 2 blocks. Routings with exactly so many blocks.
RoutingCounts brute_force_trees(const CountedTreeParts& parts, int fingers, int blocks,
                                bool identical_fingers);

}  // namespace reeve::testing
