// Sets of trees, such as those that have a block each: how many there are, and which one an index
// means.
//
// Identical fingers: multisets, size of tree by size of tree, b_s of them,
//   Σ sets(n,k) z^n y^k = Π_s Σ_m multichoose(b_s, m) (z^fingers y^blocks)^m
// Distinct fingers: the least finger's tree takes some of the others, and the rest is such a set.
#pragma once

#include <vector>

#include "search/enumerate/tree_index.hpp"

namespace reeve::search {

class TreeSets {
 public:
  // trees[size]: how many there are, each with a finger at least.
  TreeSets(const SizeTable& trees, FingerIdentity identity);

  // Sets with so many fingers and blocks in all.
  std::uint64_t count(TreeSize size) const;

  // The set with this index. Keeps the memory of `set`.
  void decode(TreeSize size, std::uint64_t index, FingerSet fingers,
              std::vector<TreeIndex>& set) const;

 private:
  void count_multisets();
  void count_labelled();
  std::uint64_t with_first(TreeSize first, TreeSize size) const;
  void decode_multiset(TreeSize size, Digits& digits, std::vector<TreeIndex>& set) const;
  void decode_labelled(TreeSize size, Digits& digits, FingerSet fingers,
                       std::vector<TreeIndex>& set) const;

  SizeTable trees_;
  FingerIdentity identity_;
  std::vector<TreeSize> sizes_;  // sizes that have trees
  std::vector<SizeTable> sets_;  // identical: [i] of trees of sizes_[i] and those behind it
};

}  // namespace reeve::search
