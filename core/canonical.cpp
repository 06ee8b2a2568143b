#include "core/canonical.hpp"

#include <algorithm>
#include <compare>
#include <utility>

#include "core/canonical_tree.hpp"
#include "core/walk_image.hpp"

namespace reeve::core {
namespace {

std::strong_ordering compare_shapes(const Walk& walk, Image a, Image b) {
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const auto order = compare_shapes(image_token(walk, a, i), image_token(walk, b, i));
    if (order != 0) return order;
  }
  return std::strong_ordering::equal;
}

std::strong_ordering compare(const Walk& walk, Image a, Image b) {
  if (const auto shape = compare_shapes(walk, a, b); shape != 0) return shape;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const auto order = image_token(walk, a, i).finger <=> image_token(walk, b, i).finger;
    if (order != 0) return order;
  }
  return std::strong_ordering::equal;
}

bool moves_a_finger(const Walk& walk, Image image) {
  for (std::size_t i = 0; i < walk.size(); ++i) {
    if (is_of_finger(walk[i].kind) && image_index(walk, image, i) != i) return true;
  }
  return false;
}

Tendon least_image(const Tendon& tendon) {
  Image least = as_it_stands;
  for_each_image(tendon, [&](Image image) {
    if (compare(tendon.walk, image, least) < 0) least = image;
    return true;
  });
  return walked(tendon, least);
}

using Tree = std::vector<Tendon>;

template <typename Number>
std::strong_ordering compare_numbers(const Tree& a, const Tree& b, Number number) {
  for (std::size_t t = 0; t < a.size(); ++t) {
    for (std::size_t i = 0; i < a[t].walk.size(); ++i) {
      const auto order = number(a[t].walk[i]) <=> number(b[t].walk[i]);
      if (order != 0) return order;
    }
  }
  return std::strong_ordering::equal;
}

int finger_count(const Tree& tree) {
  int count = 0;
  for (const Tendon& tendon : tree) count += core::finger_count(tendon);
  return count;
}

// Blocks are numbered within each tree.
bool precedes(const Tree& a, const Tree& b) {
  if (const auto fingers = finger_count(b) <=> finger_count(a); fingers != 0) return fingers < 0;
  const auto shapes = std::lexicographical_compare_three_way(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const Tendon& x, const Tendon& y) { return compare_shapes(x, y); });
  if (shapes != 0) return shapes < 0;
  const auto blocks = compare_numbers(a, b, [](const Token& token) { return token.block; });
  if (blocks != 0) return blocks < 0;
  return compare_numbers(a, b, [](const Token& token) { return token.finger; }) < 0;
}

void number_fingers_in_order(Routing& routing) {
  std::uint8_t next = 1;
  for (Tendon& tendon : routing.tendons) {
    for (Token& token : tendon.walk) {
      if (is_of_finger(token.kind)) token.finger = next++;
    }
  }
}

std::vector<Tree> canonical_trees(const Routing& routing, FingerIdentity identity) {
  const std::vector<std::size_t> tree_of = trees(routing);
  std::vector<Tree> all(tree_of.empty() ? 0
                                        : 1 + *std::max_element(tree_of.begin(), tree_of.end()));
  for (std::size_t t = 0; t < tree_of.size(); ++t) {
    all[tree_of[t]].push_back(routing.tendons[t]);
  }
  for (Tree& tree : all) {
    const bool tied = std::any_of(tree[0].walk.begin(), tree[0].walk.end(),
                                  [](const Token& token) { return is_of_block(token.kind); });
    tree = tied ? canonical_tree(tree, identity) : Tree{least_image(tree[0])};
  }
  return all;
}

// Its blocks get the next numbers.
void append(Tree tree, Routing& routing) {
  const BlockCount before = block_count(routing);
  for (Tendon& tendon : tree) {
    for (Token& token : tendon.walk) {
      if (!is_of_block(token.kind)) continue;
      const int offset = is_of_bar(token.kind) ? before.bars : before.blocks;
      token.block = static_cast<std::uint8_t>(token.block + offset);
    }
    routing.tendons.push_back(std::move(tendon));
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
  std::vector<Tree> trees = canonical_trees(routing, identity);
  std::sort(trees.begin(), trees.end(), precedes);
  Routing result;
  for (Tree& tree : trees) append(std::move(tree), result);
  if (identity == FingerIdentity::identical) number_fingers_in_order(result);
  return result;
}

}  // namespace reeve::core
