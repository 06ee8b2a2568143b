// The tendons without blocks of each size, by their index, with the class of their parts.
//
// Those of a size of which there are not too many are kept in a list; of others, of which a routing
// has few, one steps from shape to shape. Whoever steps leaves milestones, from which others go on:
// how many shapes of each class there are before one.
#pragma once

#include <cstdint>
#include <vector>

#include "search/enumerate/shape_cursor.hpp"
#include "search/limits/class_counts.hpp"
#include "search/stop_check.hpp"

namespace reeve::search {

// One of the shapes of a size.
struct ListedShape {
  int size = 0;
  std::uint64_t index = 0;
  PartClass parts = PartClasses::none;  // class of the shape as a tree (PartClasses::of_tree)
  ShapeCursor cursor;                   // used if there is no list
};

class ListedShapes {
 public:
  // Number of entries; each takes some 200 bytes.
  static constexpr std::uint64_t default_longest = 16384;

  // Keeps the classes, which have to outlive it. counts[size]: how many shapes there are.
  ListedShapes(const PartClasses& classes, const PartSet& parts,
               const std::vector<std::uint64_t>& counts,
               std::uint64_t longest_list = default_longest);

  std::uint64_t count(int size) const { return counts_[static_cast<std::size_t>(size)]; }

  // False if there is none.
  bool start(ListedShape& shape, int size) const;
  bool next(ListedShape& shape);
  // Passes the shapes that begin with the first `tokens` of this one's walk, of which it is the
  // first. Not of a size that is in a list.
  bool next_beyond(ListedShape& shape, std::size_t tokens, const ClassCounts& passed);
  bool is_listed(int size) const { return list(size) != nullptr; }
  // Goes on to this index, which is not before its own and below the count.
  void advance_to(ListedShape& shape, std::uint64_t index);
  const Tendon& tendon(const ListedShape& shape) const;

  // Counts the shapes of this size before that index, which is at most their number. Without a
  // list, counting starts from the last shape passed.
  ClassCounts counts_before(int size, std::uint64_t index);

  // Steps from shape to shape without a list; those of next() are not counted.
  std::uint64_t steps() const { return steps_; }

  // The check is read on each step from shape to shape.
  void stop_with(const StopCheck& check) { check_ = check; }

 private:
  struct List {
    std::vector<Tendon> tendons;
    std::vector<PartClass> parts;
  };

  // The shapes before a cursor's.
  struct Passed {
    ShapeCursor cursor;
    ClassCounts counts;
  };
  struct Walk {
    std::vector<Passed> milestones;  // the first at the first shape
    // Counts of the shapes before `next`, as far as the walk has no gap.
    std::uint64_t next = 0;
    ClassCounts counts;
  };

  const List* list(int size) const;
  Walk& walk(int size);
  bool step(Passed& passed);
  void leave_milestone(Walk& walk, const ShapeCursor& cursor, const ClassCounts& counts);
  PartClass parts_of(const Tendon& tendon) const { return classes_.of_tree(classes_.of(tendon)); }

  const PartClasses& classes_;
  PartSet parts_;
  std::vector<std::uint64_t> counts_;
  std::vector<List> lists_;  // [size]; empty: none
  std::vector<Walk> walks_;  // [size]; empty before the first walk
  ClassCounts one_;          // counts of a single shape
  std::uint64_t steps_ = 0;
  StopCheck check_;
};

}  // namespace reeve::search
