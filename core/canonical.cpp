#include "core/canonical.hpp"

#include <algorithm>
#include <compare>

namespace reeve::core {
namespace {

// One way to walk a tendon: token i of the image is token start + i * step of the walk.
struct Image {
  std::size_t start = 0;
  bool backward = false;
};

std::size_t index(const Walk& walk, Image image, std::size_t i) {
  const std::size_t n = walk.size();
  const std::size_t at = image.start + (image.backward ? n - i : i);
  return at < n ? at : at - n;
}

const Token& token(const Walk& walk, Image image, std::size_t i) {
  return walk[index(walk, image, i)];
}

std::strong_ordering compare_shapes(const Token& a, const Token& b) {
  if (const auto kind = a.kind <=> b.kind; kind != 0) return kind;
  return a.tip <=> b.tip;
}

std::strong_ordering compare_shapes(const Walk& walk, Image a, Image b) {
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const auto order = compare_shapes(token(walk, a, i), token(walk, b, i));
    if (order != 0) return order;
  }
  return std::strong_ordering::equal;
}

std::strong_ordering compare(const Walk& walk, Image a, Image b) {
  if (const auto shape = compare_shapes(walk, a, b); shape != 0) return shape;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const auto order = token(walk, a, i).finger <=> token(walk, b, i).finger;
    if (order != 0) return order;
  }
  return std::strong_ordering::equal;
}

// Calls visit(image) for every way to walk the tendon until it returns false.
template <typename Visit>
void for_each_image(const Tendon& tendon, Visit visit) {
  if (!tendon.closed) {
    if (visit(Image{0, false})) visit(Image{tendon.walk.size() - 1, true});
    return;
  }
  for (std::size_t i = 0; i < tendon.walk.size(); ++i) {
    if (tendon.walk[i].kind != TokenKind::finger) continue;
    if (!visit(Image{i, false}) || !visit(Image{i, true})) return;
  }
}

constexpr Image as_it_stands{0, false};

bool moves_a_finger(const Walk& walk, Image image) {
  for (std::size_t i = 0; i < walk.size(); ++i) {
    if (walk[i].kind == TokenKind::finger && index(walk, image, i) != i) return true;
  }
  return false;
}

Tendon least_image(const Tendon& tendon) {
  Image least = as_it_stands;
  for_each_image(tendon, [&](Image image) {
    if (compare(tendon.walk, image, least) < 0) least = image;
    return true;
  });
  Tendon result{{}, tendon.closed};
  for (std::size_t i = 0; i < tendon.walk.size(); ++i) {
    result.walk.push_back(token(tendon.walk, least, i));
  }
  return result;
}

std::strong_ordering compare_shapes(const Tendon& a, const Tendon& b) {
  if (const auto fingers = finger_count(b) <=> finger_count(a); fingers != 0) return fingers;
  if (const auto closed = a.closed <=> b.closed; closed != 0) return closed;
  return std::lexicographical_compare_three_way(
      a.walk.begin(), a.walk.end(), b.walk.begin(), b.walk.end(),
      [](const Token& x, const Token& y) { return compare_shapes(x, y); });
}

bool precedes(const Tendon& a, const Tendon& b) {
  if (const auto shape = compare_shapes(a, b); shape != 0) return shape < 0;
  return std::lexicographical_compare(
      a.walk.begin(), a.walk.end(), b.walk.begin(), b.walk.end(),
      [](const Token& x, const Token& y) { return x.finger < y.finger; });
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

bool is_canonical(const Tendon& tendon) {
  bool least = true;
  for_each_image(tendon, [&](Image image) {
    least = compare(tendon.walk, image, as_it_stands) >= 0;
    return least;
  });
  return least;
}

int symmetries(const Tendon& tendon) {
  int same = 0;
  int still = 0;
  for_each_image(tendon, [&](Image image) {
    if (compare_shapes(tendon.walk, image, as_it_stands) != 0) return true;
    ++same;
    if (!moves_a_finger(tendon.walk, image)) ++still;
    return true;
  });
  return same / still;
}

bool same_shape(const Tendon& a, const Tendon& b) { return compare_shapes(a, b) == 0; }

Routing canonical(const Routing& routing, FingerIdentity identity) {
  Routing result;
  for (const Tendon& tendon : routing.tendons) result.tendons.push_back(least_image(tendon));
  std::sort(result.tendons.begin(), result.tendons.end(), precedes);
  if (identity == FingerIdentity::identical) number_fingers_in_order(result);
  return result;
}

}  // namespace reeve::core
