// How many routings a set of parts allows, with anchored tips and floating blocks or without, from
// power series alone: z marks fingers, y marks blocks.
//
// Nothing is enumerated here and nothing of the generator is used: these numbers are what the
// generator is tested against.
#pragma once

#include <cstdint>

namespace reeve::testing {

// The number of kinds of each part that may be used; every kind may be used any number of times.
struct CountedParts {
  int tube_like_tips = 0;  // tip kinds, all of which let the tendon pass round the fingertip
  int passive_joins = 0;   // join kinds at the hand: T, B
  int motor_joins = 0;     // join kinds on the carriage: P
  int motor_ends = 0;      // end kinds on the carriage: M
  int fixed_ends = 0;      // end kinds at the hand: F
};

struct CountedTreeParts {
  CountedParts parts;
  bool anchored = false;  // a tendon may be tied at a fingertip
  bool linked = false;    // two tails may be tied to each other
  bool series = false;    // a root may pass several blocks
  bool barred = false;    // all blocks but those in series may be bars
  bool becketed = false;  // a tendon that passes one block may be tied to it
  bool doubled = false;   // … may pass it twice
  // Brute force only:
  int motors = 1;          // of several, each pulls something
  int passive_beside = 0;  // kinds of joins that may stand beside an end or a tail
  int motor_beside = 0;
};

struct RoutingCounts {
  std::uint64_t all = 0;         // every routing
  std::uint64_t actuated = 0;    // those whose every tree touches the motor
  std::uint64_t one_tendon = 0;  // actuated routings that are a single tree
};

// Routings with exactly so many blocks. Identical fingers may be renamed: routings that differ only
// by that are one. Throws std::overflow_error when a number in between does not fit 64 bits.
RoutingCounts count_trees(const CountedTreeParts& parts, int fingers, int blocks,
                          bool identical_fingers);

}  // namespace reeve::testing
