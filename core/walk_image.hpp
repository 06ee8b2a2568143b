// The ways to walk a tendon: an open one forwards and backwards, a loop from each of its fingers
// both ways round.
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>

#include "core/routing.hpp"

namespace reeve::core {

// Token i of the image is token start + i, or start − i, of the walk.
struct Image {
  std::size_t start = 0;
  bool backward = false;
};

inline constexpr Image as_it_stands{0, false};

inline std::size_t image_index(const Walk& walk, Image image, std::size_t i) {
  const std::size_t n = walk.size();
  const std::size_t at = image.start + (image.backward ? n - i : i);
  return at < n ? at : at - n;
}

inline Token image_token(const Walk& walk, Image image, std::size_t i) {
  const Token& token = walk[image_index(walk, image, i)];
  return image.backward ? reversed(token) : token;
}

inline Tendon walked(const Tendon& tendon, Image image) {
  Tendon result{{}, tendon.closed};
  for (std::size_t i = 0; i < tendon.walk.size(); ++i) {
    result.walk.push_back(image_token(tendon.walk, image, i));
  }
  return result;
}

// Calls visit(image) for every way to walk the tendon until it returns false.
template <typename Visit>
void for_each_image(const Tendon& tendon, Visit visit) {
  if (!tendon.closed) {
    if (visit(as_it_stands)) visit(Image{tendon.walk.size() - 1, true});
    return;
  }
  for (std::size_t i = 0; i < tendon.walk.size(); ++i) {
    if (tendon.walk[i].kind != TokenKind::finger) continue;
    if (!visit(Image{i, false}) || !visit(Image{i, true})) return;
  }
}

// Without the numbers of fingers and blocks.
inline std::strong_ordering compare_shapes(const Token& a, const Token& b) {
  if (const auto kind = a.kind <=> b.kind; kind != 0) return kind;
  if (const auto tip = a.tip <=> b.tip; tip != 0) return tip;
  if (const auto motor = a.carriage <=> b.carriage; motor != 0) return motor;
  if (const auto arms = a.arms <=> b.arms; arms != 0) return arms;
  return a.angle <=> b.angle;
}

// More fingers first, open before closed, then token by token.
inline std::strong_ordering compare_shapes(const Tendon& a, const Tendon& b) {
  if (const auto fingers = finger_count(b) <=> finger_count(a); fingers != 0) return fingers;
  if (const auto closed = a.closed <=> b.closed; closed != 0) return closed;
  return std::lexicographical_compare_three_way(
      a.walk.begin(), a.walk.end(), b.walk.begin(), b.walk.end(),
      [](const Token& x, const Token& y) { return compare_shapes(x, y); });
}

}  // namespace reeve::core
