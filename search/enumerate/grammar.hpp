// Things that are made of choices and numbered from 0.
//
// A thing is one of a few kinds, one of several sorts of things one behind the other, a choice for
// each of two things (the first of which varies first), or a multiset of things, greatest number
// first (checked.hpp). So the index of a thing is a number of mixed radix: each choice takes its
// digit, and a choice between sorts first subtracts the sizes of those before. Indices below the
// size of a sort and its things are one to one, so a thing from the middle of billions is read at
// once.
//
// Distinct fingers: things also have fingers, whose choice is the first digit of two things. What
// is unordered has the least finger on its first side.
// Renamed motors (counting.hpp): each power of a renaming leaves a number of things as they are.
#pragma once

#include <boost/container/small_vector.hpp>

#include <cstdint>
#include <utility>
#include <vector>

#include "core/canonical.hpp"
#include "core/routing.hpp"
#include "search/enumerate/checked.hpp"

namespace reeve::search {

// Sets of distinct fingers, chosen by digits of an index. With identical fingers there is nothing
// to choose: every set is empty and every finger 0, and no digits are taken.
// Bit f − 1 is finger f.
using FingerSet = std::uint64_t;

FingerSet fingers_up_to(int fingers, FingerIdentity identity);

// Number of ways to choose so many fingers; 1 for identical fingers.
std::uint64_t choices_of(int fingers, int of, FingerIdentity identity);

// Takes so many out of the set; choices_of(many, size of the set) ways.
FingerSet take_some(FingerSet& set, int many, Digits& digits, FingerIdentity identity);
// … the least and so many besides it; choices_of(many, size of the set - 1) ways.
FingerSet take_least_and(FingerSet& set, int many, Digits& digits, FingerIdentity identity);
// … any one; as many ways as the set has fingers.
int take_one(FingerSet& set, Digits& digits, FingerIdentity identity);

class Grammar {
 public:
  using Sort = std::size_t;
  using Kind = std::vector<Token>;  // tokens one behind the other

  enum class Form : std::uint8_t {
    kinds,        // one of a few
    row,          // distinct fingers: one of each of several kinds, with the fingers in any order
    ring,         // likewise, the first finger being less than the last
    choice,       // one of several sorts
    both,         // one of each of two sorts
    sides,        // likewise, on the left and right of a tendon
    labelled,     // distinct fingers: likewise, the least finger on the left
    multiset,     // several of one sort; two of them lie left and right, the lesser number left
    tail,         // a branch at the end of a tendon, by itself
    beside_tail,  // what stands before the tail
    hung,         // a branch, whose block or bar hangs by `token`
    loop,         // a closed tendon
    riser,        // a tendon of its own, whose block is passed here
    tree,         // one of a set of trees
  };

  struct Node {
    Form form{};
    std::vector<Sort> of{};
    std::vector<Kind> kinds{};
    int many = 0;     // members of a multiset
    int fingers = 0;  // number of distinct fingers
    Token token{};
  };

  // `powers` is the number of powers of the renaming of motors; size(sort, 0) counts all things.
  explicit Grammar(FingerIdentity identity, std::size_t powers = 1)
      : identity_(identity), powers_(powers) {}

  FingerIdentity identity() const { return identity_; }

  // sizes[power]: how many of the kinds that power leaves as they are.
  Sort kinds(std::vector<Kind> kinds, const std::vector<std::uint64_t>& sizes);
  Sort kinds(std::vector<Kind> kinds);
  // One of each. With distinct fingers every second kind, from the first on, is of a finger.
  Sort row(const std::vector<Sort>& kinds);
  // Distinct fingers alone.
  Sort ring(const std::vector<Sort>& kinds) { return arranged(Form::ring, kinds); }
  Sort choice(std::vector<Sort> sorts);
  Sort both(Sort first, Sort second) { return two(Form::both, first, second); }
  Sort sides(Sort left, Sort right) { return two(Form::sides, left, right); }
  Sort labelled(Sort left, Sort right) { return two(Form::labelled, left, right); }
  // Identical fingers alone; two members where motors are renamed.
  Sort multiset(Sort of, int many);
  Sort part(Form form, Sort of, const Token& token = {});

  std::size_t sorts() const { return nodes_.size(); }
  const Node& node(Sort sort) const { return nodes_[sort]; }
  std::uint64_t size(Sort sort, std::size_t power = 0) const {
    return sizes_[sort * powers_ + power];
  }

  // A thing of a sort, with its distinct fingers.
  struct Thing {
    Sort sort = 0;
    std::uint64_t index = 0;
    FingerSet fingers = 0;

    friend bool operator==(const Thing&, const Thing&) = default;
  };

  // Returns the thing that a choice chooses.
  Thing chosen(const Thing& thing) const;
  // Returns both parts of a pair, of two sides or of a labelled thing.
  std::pair<Thing, Thing> split(const Thing& thing) const;
  // Members of a multiset come greatest first.
  using Members = boost::container::small_vector<Thing, 8>;
  Members members(const Thing& thing) const;
  // Appends the tokens of kinds, of a row or of a ring.
  void append_tokens(const Thing& thing, Walk& walk) const;

 private:
  Sort add(Node node, const std::vector<std::uint64_t>& sizes);
  Sort two(Form form, Sort first, Sort second);
  Sort arranged(Form form, const std::vector<Sort>& kinds);
  template <typename SizeAt>
  std::vector<std::uint64_t> at_powers(SizeAt size_at) const;
  void append_kind(Sort kinds, Digits& digits, Walk& walk) const;
  void append_row(const Node& row, Digits& digits, FingerSet fingers, Walk& walk) const;
  void append_ring(const Node& ring, Digits& digits, FingerSet fingers, Walk& walk) const;

  FingerIdentity identity_;
  std::size_t powers_;
  std::vector<Node> nodes_;
  std::vector<std::uint64_t> sizes_;  // [sort * powers + power]
};

}  // namespace reeve::search
