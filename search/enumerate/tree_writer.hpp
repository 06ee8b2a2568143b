// The words of trees: from an index to tendons in the order of core/canonical_tree.hpp.
//
// Each tendon is walked the way that makes the lesser word, by its tokens and, where these read the
// same both ways, with the lesser branch first; the tendons stand level by level, and the blocks
// are numbered as they appear. So with identical fingers what is written is canonical. With
// distinct fingers the numbers decide, too, and are left to core's canonical().
#pragma once

#include <vector>

#include "search/enumerate/tree_index.hpp"

namespace reeve::search {

// Tendons one after the other; keeps the memory of those no longer in use.
struct TendonList {
  std::vector<Tendon> tendons;
  std::size_t used = 0;

  Tendon& add() {
    if (used == tendons.size()) tendons.emplace_back();
    return tendons[used++];
  }
};

class TreeWriter {
 public:
  explicit TreeWriter(const TreeDecoder& decoder) : decoder_(decoder) {
    branches_.reserve(max_generated_blocks);
  }

  // Appends the tree's tendons. Blocks are numbered from 1, fingers not at all (identical) or as
  // the index says.
  void write(const TreeIndex& tree, TendonList& list);

 private:
  void write_below(std::vector<TreeIndex>& branches, TendonList& list);
  void write_tendon(SplitTendon& tendon, int own_block, std::vector<TreeIndex>& branches,
                    TendonList& list);
  bool stands_backwards(const SplitTendon& tendon, const Walk& walk) const;
  bool precedes(const TreeIndex& a, const TreeIndex& b) const;

  const TreeDecoder& decoder_;
  SplitTendon tendon_;
  std::vector<TreeIndex> branches_;
};

}  // namespace reeve::search
