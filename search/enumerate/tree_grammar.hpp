// The trees of tendons, tied together by floating blocks, that a set of parts makes.
//
// A tree hangs on a root, a tendon that passes no block. Every block has one tail, at an end of a
// tendon above it, and one tendon that passes it; below every block hangs a finger; no tendon
// passes two blocks. A string of m fingers is f J f … f; before an end or a tail may stand one of
// the joins beside it. Of n fingers and k blocks, and in the order of their numbers:
//   half     of a tendon, from its pass outwards. k = 0: a string that ends in a finger with an
//            end, or in an anchored tip; n = 0: an end; k > 0: a tail, or a string and a tail
//   side     of a tendon that passes a block: a half, or with beckets a string and a becket
//   branch   a block with all that is below it: two passes, each before a side, about a string;
//            a pass, and a loop or two sides; and for a bar, whose arms follow from what is below,
//            a loop or two halves once more
//   tree     M and a tail, or an end, a join and a tail of which not both are fixed to the hand;
//            a string to an end, and a tail; two tails about a string, or about a join, or about
//            nothing if they may be linked
// Where blocks may stand in series, a root may also pass q > 1 blocks. Each of them hangs on a
// riser, a tendon that passes none and has a finger on or below it. Between two passes stands a
// bead: nothing or a join. There are then no joins beside ends.
//   riser    a half with a finger, but no tail alone unless tails may be linked
//   arm      of the root, with q passes, from its middle outwards: a half; or a pass with its
//            riser, a bead and a shorter arm
//   tree     two arms about a bead, or about a pass with its riser, a bead before each
// A string between equal halves is a bead in the middle and a mirrored half on each side; with
// distinct fingers nothing is its own reversal, and all of it is the middle.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "search/enumerate/grammar.hpp"
#include "search/enumerate/parts.hpp"

namespace reeve::search {

// Fingers on a tree, or a part of it, and blocks in it.
struct TreeSize {
  int fingers = 0;
  int blocks = 0;

  friend auto operator<=>(const TreeSize&, const TreeSize&) = default;
};

constexpr TreeSize operator-(const TreeSize& a, const TreeSize& b) {
  return {a.fingers - b.fingers, a.blocks - b.blocks};
}

constexpr TreeSize operator*(int many, const TreeSize& size) {
  return {many * size.fingers, many * size.blocks};
}

constexpr bool is_within(const TreeSize& size, const TreeSize& whole) {
  return size.fingers <= whole.fingers && size.blocks <= whole.blocks;
}

template <typename Visit>
void for_each_size(TreeSize largest, Visit visit) {
  for (int fingers = 0; fingers <= largest.fingers; ++fingers) {
    for (int blocks = 0; blocks <= largest.blocks; ++blocks) visit(TreeSize{fingers, blocks});
  }
}

// The parts that the powers of a renaming of the motors leave as they are, each as often as there
// are such carriages: at [0] all of them, and behind the last again the first.
using PartPowers = std::vector<PartSet>;

class TreeGrammar {
 public:
  using Sort = Grammar::Sort;

  TreeGrammar(PartPowers powers, int fingers, FingerIdentity identity);

  const Grammar& grammar() const { return grammar_; }

  // Trees with a block at least.
  Sort tree(TreeSize size);
  // Sets of such trees that have this size in all. Motors are not renamed.
  Sort sets(TreeSize size);

 private:
  enum class Name : std::uint8_t {
    string,
    to_end,
    mirrored,
    mirrored_tail,
    passed_again,
    tail,
    half,
    side,
    branch,
    riser,
    arm,
    tree,
    sets
  };

  // Looks the sort of this name, number and size up, and makes it the first time.
  template <typename Make>
  Sort known(Name name, int number, TreeSize size, Make make);
  // Kinds that parts have.
  template <typename KindsOf>
  Sort kinds(KindsOf kinds_of);

  const PartSet& parts() const { return powers_.front(); }
  bool are_identical() const { return grammar_.identity() == FingerIdentity::identical; }
  std::vector<Sort> beads(int m) const;
  Sort string(int m);
  Sort to_end(int m);
  Sort middle(int m);
  Sort mirrored_half(int m);
  Sort loop(Sort through, int m);
  Sort tail(TreeSize size);
  Sort tailed(TreeSize size);
  std::vector<Sort> strings_to_tail(TreeSize size);
  Sort half(TreeSize size);
  Sort side(TreeSize size);
  Sort branch(TreeSize size);
  Sort pulley(TreeSize size);
  Sort double_pass(int m, TreeSize of_sides);
  Sort riser(TreeSize size);
  Sort arm(int passes, TreeSize size);
  Sort beaded_arm(int passes, TreeSize size);
  Sort two_tailed(int m, TreeSize below);
  Sort in_series(int passes, TreeSize size);
  Sort multisets_from(std::size_t first, TreeSize size);
  Sort labelled_sets(TreeSize size);
  template <typename Member>
  Sort pairs(TreeSize size, Member member);
  template <typename Member>
  Sort once_passed(Sort through, TreeSize size, Member member);
  template <typename Others>
  Sort beside_risers(TreeSize size, Others others);

  PartPowers powers_;
  TreeSize largest_;
  Grammar grammar_;
  Sort nothing_;  // there is none of it
  Sort empty_;    // there is one of it, without parts
  Sort tips_;
  Sort joins_;
  Sort ends_;
  Sort last_fingers_;
  Sort beside_;
  Sort between_tails_;
  Sort beads_;
  Sort hanging_;
  Sort pass_;
  Sort arms_;
  Sort becket_;
  std::map<std::tuple<Name, int, TreeSize>, Sort> known_;
  std::vector<TreeSize> sizes_;  // sizes that have trees, once sets were asked for
};

}  // namespace reeve::search
