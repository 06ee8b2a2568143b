// The words of trees: from an index to tendons in the order of core/canonical_tree.hpp.
//
// Each tendon is walked the way that makes the lesser word, by its tokens and, where these read the
// same both ways, with the lesser branch first; the tendons stand level by level, and the blocks
// are numbered as they appear. So with identical fingers what is written is canonical. Blocks in
// series are left to core's canonical(), and so are distinct fingers, whose numbers decide, too.
#pragma once

#include <optional>
#include <vector>

#include "core/routing.hpp"
#include "search/enumerate/grammar.hpp"
#include "search/enumerate/parts.hpp"

namespace reeve::search {

// A tendon from its middle outwards. The tail at its end, if it has one, is not among the tokens.
struct HalfTendon {
  Walk tokens;
  Walk beside_tail;                    // what stands before the tail
  std::optional<Grammar::Thing> tail;  // its branch
};

// The middle is the pass of a branch, or what a root has between its halves, or what is between two
// passes, which then begin the halves. A loop has its pass first in the middle, and nothing at the
// ends of its halves. A root that passes blocks in series numbers them from 1, and on their tails
// are the risers, [block - 1].
struct SplitTendon {
  HalfTendon left;
  HalfTendon middle;
  HalfTendon right;
  bool closed = false;
  std::vector<HalfTendon> risers{};
};

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
  explicit TreeWriter(const Grammar& grammar) : grammar_(grammar) {
    branches_.reserve(max_generated_blocks);
  }

  // Appends the tree's tendons. Blocks, and bars likewise, are numbered from 1, fingers not at all
  // (identical) or as the index says.
  void write(const Grammar::Thing& tree, TendonList& list);

 private:
  using Thing = Grammar::Thing;

  void read(const Thing& thing, HalfTendon& half, SplitTendon& tendon) const;
  void read_sides(const Thing& left, const Thing& right, SplitTendon& tendon) const;
  // The tendon that passes the branch's block, or is tied to its bar's arms.
  void read_branch(const Thing& branch, SplitTendon& tendon) const;
  // Sides of tendons that hang on no further block.
  int sides_below(const Thing& branch) const;
  int sides_below(const HalfTendon& half) const;
  ArmRatio arms_between(const SplitTendon& sides) const;
  // The end without number that is tied to the tail of the branch's block, or to its bar's pivot.
  Token tail_of(Thing branch) const;

  void write_below(std::vector<Thing>& branches, TendonList& list, std::size_t from = 0);
  void write_risers(TendonList& list);
  void write_tendon(SplitTendon& tendon, int own_block, std::vector<Thing>& branches,
                    TendonList& list);
  void join_halves(const SplitTendon& split, Tendon& tendon) const;
  bool stands_backwards(const SplitTendon& tendon, const Walk& walk) const;
  bool precedes(const Thing& a, const Thing& b) const;

  const Grammar& grammar_;
  SplitTendon tendon_;
  std::vector<Thing> branches_;
};

}  // namespace reeve::search
