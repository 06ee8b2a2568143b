// Numbers of trees of tendons, tied together by floating blocks, that a set of parts makes.
//
// A tree hangs on a root, a tendon that passes no block. Every block has one tail, at an end of a
// tendon above it, and one tendon that passes it; below every block hangs a finger; no tendon
// passes two blocks. With t tip kinds, J join kinds, b kinds of joins that may stand beside an end
// or a tail, v = 1 + b, e end kinds times v, x = 1 where tips may be anchored, n fingers, k blocks:
//   half     H(n,k)  of a tendon, from its pass outwards: m fingers, then an end, an anchored tip
//                    or a tail. H(n,0) = (tJ)^(n-1) (x + te), H(0,0) = e;
//                    for k > 0: v C(n,k) + v Σ_m t^m J^(m-1) C(n-m,k)
//   side     S(n,k)  of a tendon that passes a block: H(n,k), and where there are beckets, for
//                    k = 0 and n > 0, t^n J^(n-1) that end in one of that block
//   branch   C(n,k)  a block with all that is below it: the unordered pairs of sides with n
//                    fingers and k-1 blocks, and for k = 1 the loops of n fingers and the pass;
//                    where it may be passed twice, for each m < n the pairs of sides with n-m
//                    fingers, a pass before each, about m fingers; and where it may be a bar, whose
//                    arms follow from what is below, pairs of halves and loops once more
//   tree     R(n,k)  k > 0: M-Y1, or an end, a join and a tail of which not both are fixed to the
//                    hand, C(n,k) each; one tail and an end or an anchored tip,
//                    v Σ_m (e t^m + x t^(m-1)) J^(m-1) C(n-m,k); between two tails nothing, where
//                    they may be linked, b joins, or m fingers: an unordered pair of branches, each
//                    with half of the walk, about the bead in its middle
// Where blocks may stand in series, a root may also pass q > 1 blocks. Each of them hangs on a
// riser, a tendon that passes none and has a finger on or below it. Between two passes stands one
// of g = 1 + J beads, nothing or a join; b = 0:
//   riser    U(n,k)  from the block's tail outwards: H(n,k) for n > 0, less C(n,k) unless tails may
//                    be linked
//   arm      A(q,n,k) of the root, with q passes, from its middle outwards: A(0,n,k) = H(n,k), and
//                    Σ U(m,l) A(q-1,n-m,k-l-1), times g for q > 1
//   tree     an unordered pair of arms of q passes each, about one of g beads; or about a pass with
//                    its riser, where each arm has one of g beads before it
// Unordered pairs of equals are counted by (X² + X)/2 (Burnside for the reversal). With distinct
// fingers nothing is its own reversal, so the first of a pair is the one with the least finger.
// Where motors are renamed (counting.hpp), the X that stands alone counts what the renaming, done
// twice, leaves as it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/canonical.hpp"
#include "search/enumerate/parts.hpp"

namespace reeve::search {

// Fingers on a tree, or a part of it, and blocks in it.
struct TreeSize {
  int fingers = 0;
  int blocks = 0;

  friend bool operator==(const TreeSize&, const TreeSize&) = default;
};

constexpr TreeSize operator-(const TreeSize& a, const TreeSize& b) {
  return {a.fingers - b.fingers, a.blocks - b.blocks};
}

template <typename Visit>
void for_each_size(TreeSize largest, Visit visit) {
  for (int fingers = 0; fingers <= largest.fingers; ++fingers) {
    for (int blocks = 0; blocks <= largest.blocks; ++blocks) visit(TreeSize{fingers, blocks});
  }
}

// A number for each size.
class SizeTable {
 public:
  SizeTable() = default;
  explicit SizeTable(TreeSize largest)
      : largest_(largest), counts_(at({largest.fingers + 1, 0}), 0) {}

  TreeSize largest() const { return largest_; }
  std::uint64_t& operator[](TreeSize size) { return counts_[at(size)]; }
  std::uint64_t operator[](TreeSize size) const { return counts_[at(size)]; }

 private:
  std::size_t at(TreeSize size) const {
    const auto columns = static_cast<std::size_t>(largest_.blocks) + 1;
    return static_cast<std::size_t>(size.fingers) * columns + static_cast<std::size_t>(size.blocks);
  }

  TreeSize largest_;
  std::vector<std::uint64_t> counts_;
};

// Factors for the numbers of fingers; 1 for identical fingers.
std::uint64_t choices_of(int fingers, int of, FingerIdentity identity);
std::uint64_t orders_of(int fingers, FingerIdentity identity);

// Variants of an end or a tail: alone, or with one of the joins that may stand beside it.
inline std::uint64_t end_variants(const PartSet& parts) { return 1 + parts.beside.size(); }

// Strings of tips and joins through m fingers: f J f … f.
std::uint64_t strings(const PartSet& parts, int m);
// … of which the last finger is an anchored tip, or has an end behind it.
std::uint64_t one_sided_strings(const PartSet& parts, int m);

// A string about the bead in its middle. With distinct fingers all of it is the middle.
struct MirroredString {
  std::uint64_t middles = 0;
  std::uint64_t halves = 0;
};
MirroredString mirrored(const PartSet& parts, int m, FingerIdentity identity);

// … with what may stand beside the two tails at its ends; for m = 0 a join between them, before
// all joins none where tails may be linked.
MirroredString between_tails(const PartSet& parts, int m, FingerIdentity identity);

// Loops of m fingers and a pass.
std::uint64_t loops_through_pass(const PartSet& parts, int m, FingerIdentity identity);

// The parts that the powers of a renaming of the motors leave as they are, each as often as there
// are such carriages: at [0] all of them, and behind the last again the first.
using PartPowers = std::vector<PartSet>;

// M-Y1 is a tendon; F-Y1 would be a pulley that is fixed.
bool may_hang_on_motor(const PartSet& parts);
// F-P-Y1 and M-T-Y1 are tendons; F-T-Y1 would be such a pulley. Likewise of each end in their order
// and for each of them its joins.
bool may_hang(TokenKind end, TokenKind beside);

// Beads before an arm with so many passes, behind another pass: nothing, or a join if it has any.
inline std::uint64_t beads_before(const PartSet& parts, int passes) {
  return passes > 0 ? 1 + parts.joins.size() : 1;
}

// The members of an unordered pair: with identical fingers the lesser size first, with distinct
// ones the one that has the least finger.
struct SizePair {
  TreeSize first;
  TreeSize second;
};
// The splits of a size are Split{{}, size} and what this makes of it until it is false.
bool next_pair(SizePair& split);
// One side of a pair: `variants` of each of table[size].
struct PairSide {
  const SizeTable& table;
  std::uint64_t variants = 1;

  std::uint64_t count(TreeSize size) const;
};
// Counts pairs with the two sizes of the split. `twice` counts those that a renaming of motors,
// done twice, leaves unchanged.
std::uint64_t pairs(const PairSide& side, const PairSide& twice, const SizePair& split,
                    FingerIdentity identity);
inline std::uint64_t pairs(const PairSide& side, const SizePair& split, FingerIdentity identity) {
  return pairs(side, side, split, identity);
}

std::uint64_t all_pairs(const PairSide& side, const PairSide& twice, TreeSize size,
                        FingerIdentity identity);

struct TreeCounts {
  SizeTable halves;
  SizeTable sides;
  SizeTable pulleys;  // branches that are no bars
  SizeTable branches;
  // Tendons that pass their block twice with m fingers in between, [m], by the size of both sides.
  std::vector<SizeTable> double_passes;
  // Roots with m fingers between two tails, [m], or for [0] a join or nothing, by the size of what
  // hangs on both.
  std::vector<SizeTable> two_tailed;
  SizeTable risers;
  std::vector<SizeTable> arms;       // [passes]
  std::vector<SizeTable> in_series;  // roots, [passes]
  SizeTable trees;                   // trees with at least one block
};

// Counts the risers of the first size of a split, each with all others of the second.
std::uint64_t with_riser(const TreeCounts& counts, const SizePair& split, std::uint64_t others,
                         FingerIdentity identity);

// Counts the trees that each power of the renaming leaves unchanged.
std::vector<TreeCounts> tree_counts(const PartPowers& powers, int fingers, FingerIdentity identity);
inline TreeCounts tree_counts(const PartSet& parts, int fingers, FingerIdentity identity) {
  return tree_counts(PartPowers{parts}, fingers, identity).front();
}

}  // namespace reeve::search
