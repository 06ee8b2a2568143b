// One canonical word for every routing.
//
// Routings that differ only by swapping the two strands of a finger, by walking a tendon backwards,
// by where a loop is entered, by the order of the tendons, or (for identical fingers) by the
// numbers of the fingers, are one routing. The canonical form is the least of them in this order:
//   tendons: more fingers first, open before closed, then shape, then finger numbers;
//   shapes:  token by token, M < F < finger (tube tip < bearing tip) < T < B < P;
// and, for identical fingers, fingers numbered in the order in which the word passes them.
#pragma once

#include <compare>

#include "core/routing.hpp"

namespace reeve {

enum class FingerIdentity {
  identical,  // fingers may be renamed: M-1-P-2-F is M-2-P-1-F
  distinct,   // every finger is itself
};

// The order of single tokens and of whole walks, finger numbers left out.
std::strong_ordering compare_shapes(const Token& a, const Token& b);
std::strong_ordering compare_shapes(const Tendon& a, const Tendon& b);

Routing canonical(const Routing& routing, FingerIdentity identity);

}  // namespace reeve
