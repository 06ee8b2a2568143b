// One canonical word for every routing.
//
// Routings that differ only by swapping the two strands of a finger, by walking a tendon backwards,
// by where a loop is entered, by the order of the tendons, by the numbers of the blocks, or (for
// identical fingers) by the numbers of the fingers and of the motors, are one routing. The
// canonical form is the least of them in this order:
//   tendons: more fingers first, open before closed, then shape, then finger numbers;
//   shapes:  token by token, M < M2 < F < 1x < 1e < tail < becket < pivot < finger (tube tip <
//            bearing tip) < block < bar (by its ratio) < T < B < P < P2;
// and, for identical fingers, fingers numbered in the order in which the word passes them. Those
// that two tendons share are first numbered in all ways, of which the least word counts. Tendons
// that blocks tie together are one tree and stay side by side, in the order of canonical_tree.hpp.
#pragma once

#include <cstddef>
#include <span>

#include "core/routing.hpp"

namespace reeve::core {

enum class FingerIdentity {
  identical,  // fingers may be renamed: M-1-P-2-F is M-2-P-1-F; motors likewise
  distinct,   // every finger, and every motor, is itself
};

// True if no other way to walk this tendon (backwards, or from another finger of a loop) comes
// earlier in the order of shapes and then of finger numbers.
bool is_canonical(const Tendon& tendon);

// Returns a number of first tokens with which no tendon is canonical that has as many in all.
// Returns 0 if this one is.
std::size_t uncanonical_tokens(const Tendon& tendon);

// Size of the group of finger permutations that leave this tendon's shape as it is: 1, or 2 for a
// palindrome, on a loop up to twice its number of fingers.
int symmetries(const Tendon& tendon);

// Numbers the blocks, and the bars likewise, as they appear.
void number_blocks_in_order(std::span<Tendon> tendons);

bool same_shape(const Tendon& a, const Tendon& b);

Routing canonical(const Routing& routing, FingerIdentity identity);

}  // namespace reeve::core
