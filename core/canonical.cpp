#include "core/canonical.hpp"

#include <algorithm>
#include <utility>

namespace reeve {

std::strong_ordering compare_shapes(const Token& a, const Token& b) {
  if (const auto kind = a.kind <=> b.kind; kind != 0) return kind;
  return a.tip <=> b.tip;
}

std::strong_ordering compare_shapes(const Tendon& a, const Tendon& b) {
  if (const auto fingers = finger_count(b) <=> finger_count(a); fingers != 0) return fingers;
  if (const auto closed = a.closed <=> b.closed; closed != 0) return closed;
  return std::lexicographical_compare_three_way(
      a.walk.begin(), a.walk.end(), b.walk.begin(), b.walk.end(),
      [](const Token& x, const Token& y) { return compare_shapes(x, y); });
}

namespace {

bool precedes(const Tendon& a, const Tendon& b) {
  if (const auto shape = compare_shapes(a, b); shape != 0) return shape < 0;
  return std::lexicographical_compare(
      a.walk.begin(), a.walk.end(), b.walk.begin(), b.walk.end(),
      [](const Token& x, const Token& y) { return x.finger < y.finger; });
}

Tendon reversed(const Tendon& tendon) {
  return {{tendon.walk.rbegin(), tendon.walk.rend()}, tendon.closed};
}

Tendon least_rotation(const Tendon& loop) {
  Tendon least = loop;
  Tendon turned = loop;
  for (std::size_t i = 1; i < loop.walk.size(); ++i) {
    std::rotate(turned.walk.begin(), turned.walk.begin() + 1, turned.walk.end());
    if (turned.walk.front().kind == TokenKind::finger && precedes(turned, least)) least = turned;
  }
  return least;
}

Tendon canonical(const Tendon& tendon) {
  Tendon forward = tendon;
  Tendon backward = reversed(tendon);
  if (tendon.closed) {
    // A loop begins with a finger, so its mirror image has to be turned by one to do so too.
    std::rotate(backward.walk.begin(), backward.walk.end() - 1, backward.walk.end());
    forward = least_rotation(forward);
    backward = least_rotation(backward);
  }
  return precedes(backward, forward) ? backward : forward;
}

void number_fingers_in_order(Routing& routing) {
  std::uint8_t next = 1;
  for (Tendon& tendon : routing.tendons) {
    for (Token& token : tendon.walk) {
      if (token.kind == TokenKind::finger) token.finger = next++;
    }
  }
}

}  // namespace

Routing canonical(const Routing& routing, FingerIdentity identity) {
  Routing result;
  for (const Tendon& tendon : routing.tendons) result.tendons.push_back(canonical(tendon));
  std::sort(result.tendons.begin(), result.tendons.end(), precedes);
  if (identity == FingerIdentity::identical) number_fingers_in_order(result);
  return result;
}

}  // namespace reeve
