// The trees that a routing is made of, each with a key by which it is known again.
//
// Tendons that floating blocks tie together are a tree, and so is a tendon alone. Where no finger
// differs from another, what a tree does follows from its tokens: its key holds kind and tip of
// each, the numbers of blocks and bars counted from the least, arms of bars, and nothing of its
// fingers' numbers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/performance.hpp"
#include "core/routing.hpp"

namespace reeve::search {

// Sums that a tree's state adds to a routing (t_i: shared_states.hpp). They suffice to see that a
// design is far from the kept ones.
struct TreeSums {
  bool jams = false;
  bool in_range = true;
  double motor = 0;     // Σ t_j of the motor-side segments
  StrandTally strands;  // tally of the t_i

  bool has_strands() const { return strands.least <= strands.most; }
  TreeSums& operator+=(const TreeSums& other);
};

struct TreeOutline {
  PartCount parts;
  int fingers = 0;
  std::vector<TreeSums> sums;  // [0]: no finger held; [f]: finger f held
};

// Four bits a token, four more for a block's number, and eight for a bar's arms.
struct TreeKey {
  static constexpr std::size_t words = 4;
  static constexpr std::size_t capacity = 16 * words;

  std::array<std::uint64_t, words> bits{};

  friend bool operator==(const TreeKey&, const TreeKey&) = default;

  struct Hash {
    std::size_t operator()(const TreeKey& key) const;
  };
};

struct TreeSpan {
  std::size_t begin = 0;  // index into the routing's tendons
  std::size_t end = 0;
  int fingers_before = 0;
  int fingers = 0;
  TreeKey key;
};

// False where it gives a wrap angle, where the fingers are not numbered in the order
// of the word, or where a tree is too large for its key. Keeps the memory of `spans`.
bool split_into_trees(const Routing& routing, std::vector<TreeSpan>& spans);

// The tree by itself: fingers and blocks from 1 on. Keeps the memory of `tree`.
void copy_tree(const Routing& routing, const TreeSpan& span, Routing& tree);

}  // namespace reeve::search
