// Numbers trees of tendons and builds a tree from its number: tree_counts.hpp, read backwards.
//
// An index is a number of mixed radix. Each choice takes its digit; a choice between sizes first
// subtracts the counts of the sizes before. Indices below the count of a size and its trees are one
// to one, so a tree from the middle of billions is built at once.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/canonical.hpp"
#include "core/routing.hpp"
#include "search/enumerate/checked.hpp"
#include "search/enumerate/tree_counts.hpp"

namespace reeve::search {

// Sets of distinct fingers, chosen by digits of an index. With identical fingers there is nothing
// to choose: every set is empty and every finger 0, and no digits are taken.
// Bit f − 1 is finger f.
using FingerSet = std::uint64_t;

FingerSet fingers_up_to(int fingers, FingerIdentity identity);

// Takes so many out of the set; choices_of(many, size of the set) ways.
FingerSet take_some(FingerSet& set, int many, Digits& digits, FingerIdentity identity);
// … the least and so many besides it; choices_of(many, size of the set - 1) ways.
FingerSet take_least_and(FingerSet& set, int many, Digits& digits, FingerIdentity identity);
// … any one; as many ways as the set has fingers.
int take_one(FingerSet& set, Digits& digits, FingerIdentity identity);

// A tree, or a branch: a block with everything below it.
struct TreeIndex {
  TreeSize size;
  std::uint64_t index = 0;
  FingerSet fingers = 0;

  friend bool operator==(const TreeIndex&, const TreeIndex&) = default;
};

// A tendon from its middle outwards. The tail at its end, if it has one, is not among the tokens.
struct HalfTendon {
  Walk tokens;
  std::optional<TreeIndex> tail;
};

// The middle is the pass of a branch, as a block or bar without number, or what a root has between
// its halves, or what is between two passes, which then begin the halves. A loop is all middle,
// from its pass on. A root that passes blocks in series numbers them from 1, and on their tails are
// the risers, [block - 1].
struct SplitTendon {
  HalfTendon left;
  Walk middle;
  HalfTendon right;
  bool closed = false;
  std::vector<HalfTendon> risers{};
};

class TreeDecoder {
 public:
  TreeDecoder(const PartSet& parts, const TreeCounts& counts, FingerIdentity identity)
      : parts_(parts), counts_(counts), identity_(identity) {}

  bool has_bars() const { return parts_.bars; }

  // The end without number that is tied to the tail of the branch's block, or to its bar's pivot.
  Token tail_of(const TreeIndex& branch) const;
  // The tendon that passes the branch's block, or is tied to its bar's arms.
  void decode_branch(const TreeIndex& branch, SplitTendon& tendon) const;
  // The root of a tree with a block at least.
  void decode_root(const TreeIndex& tree, SplitTendon& tendon) const;

 private:
  struct Pair {
    TreeIndex first;
    TreeIndex second;
  };

  void append_join(Digits& digits, Walk& walk) const;
  void append_finger(FingerSet& fingers, Digits& digits, Walk& walk) const;
  void append_string(int m, FingerSet& fingers, Digits& digits, Walk& walk) const;
  void append_to_end(int m, FingerSet& fingers, Digits& digits, Walk& walk) const;
  // An end or a tail's `variant`: no join, or one of those that may stand beside it.
  void append_beside(std::uint64_t variant, Walk& walk) const;
  // The middle of a string of m fingers, with distinct ones all of it.
  void append_middle(int m, std::uint64_t middles, FingerSet& fingers, Digits& digits,
                     Walk& walk) const;
  void append_mirrored(int m, std::uint64_t index, Walk& walk) const;
  void append_loop(int m, FingerSet fingers, Digits& digits, Walk& walk) const;
  // Halves of this size with m fingers above a tail.
  std::uint64_t tailed_halves(int m, TreeSize size) const;
  void decode_half(const TreeIndex& half, HalfTendon& tendon) const;
  void decode_side(const TreeIndex& side, HalfTendon& tendon) const;
  bool is_bar(const TreeIndex& branch) const;
  // … with a pass also where the branch is a bar.
  void decode_passing(const TreeIndex& branch, SplitTendon& tendon) const;
  // Sides of tendons that hang on no further block.
  int sides_below(const TreeIndex& branch) const;
  int sides_below(const HalfTendon& half) const;
  ArmRatio arms_between(const SplitTendon& sides) const;
  bool decode_hanging(const TreeIndex& tree, Digits& digits, SplitTendon& tendon) const;
  void decode_double_pass(int m, TreeSize of_sides, FingerSet fingers, Digits& digits,
                          SplitTendon& tendon) const;
  void decode_two_tailed(int m, TreeSize below, FingerSet fingers, Digits& digits,
                         SplitTendon& tendon) const;
  // Appends a pass to the walk and its riser to the tendon. Returns the others, of which there are
  // so many of each size.
  template <typename Others>
  TreeIndex decode_pass(const TreeIndex& whole, Others others, Walk& walk,
                        SplitTendon& tendon) const;
  void append_bead(std::uint64_t bead, Walk& walk) const;
  void decode_arm(int passes, const TreeIndex& arm, HalfTendon& half, SplitTendon& tendon) const;
  // … with the bead before it.
  void decode_beaded(int passes, TreeIndex arm, HalfTendon& half, SplitTendon& tendon) const;
  void decode_in_series(int passes, const TreeIndex& tree, SplitTendon& tendon) const;
  Pair decode_pair(const SizeTable& table, std::uint64_t variants, TreeSize size, FingerSet fingers,
                   Digits& digits) const;

  const PartSet& parts_;
  const TreeCounts& counts_;
  FingerIdentity identity_;
};

}  // namespace reeve::search
