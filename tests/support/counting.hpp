// How many routings a set of parts allows, from counting formulas alone.
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

struct RoutingCounts {
  std::uint64_t all = 0;         // every routing
  std::uint64_t actuated = 0;    // those whose every tendon touches the motor
  std::uint64_t one_tendon = 0;  // actuated routings that are a single tendon
};

// Fingers may be renamed: routings that differ only by that are one.
// Throws std::invalid_argument on a negative number of kinds or fingers < 1, std::overflow_error
// when a number in between does not fit 64 bits.
RoutingCounts count_identical(const CountedParts& parts, int fingers);

// Fingers carry their numbers. Throws as count_identical does.
RoutingCounts count_distinct(const CountedParts& parts, int fingers);

}  // namespace reeve::testing
