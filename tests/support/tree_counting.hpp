// How many routings with anchored tips and floating blocks a set of parts allows, from power series
// alone: z marks fingers, y marks blocks.
//
// As counting.hpp: nothing is enumerated and nothing of the generator is used.
#pragma once

#include <cstdint>

#include "tests/support/counting.hpp"

namespace reeve::testing {

struct CountedTreeParts {
  CountedParts parts;
  bool anchored = false;  // a tendon may be tied at a fingertip
  bool linked = false;    // two tails may be tied to each other
  bool series = false;    // a root may pass several blocks
  bool barred = false;    // all blocks but those in series may be bars
  // Brute force only:
  int motors = 1;          // of several, each pulls something
  int passive_beside = 0;  // kinds of joins that may stand beside an end or a tail
  int motor_beside = 0;
};

// Routings with exactly so many blocks. Throws std::overflow_error when a number in between does
// not fit 64 bits.
RoutingCounts count_trees(const CountedTreeParts& parts, int fingers, int blocks,
                          bool identical_fingers);

}  // namespace reeve::testing
