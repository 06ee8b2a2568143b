// The tendons without blocks of each size, by their index, with the class of their parts.
//
// Those of a size of which there are not too many are kept in a list; of others, of which a routing
// has few, one steps from shape to shape.
#pragma once

#include <cstdint>
#include <vector>

#include "search/enumerate/shape_cursor.hpp"
#include "search/limits/class_counts.hpp"

namespace reeve::search {

// One of the shapes of a size.
struct ListedShape {
  int size = 0;
  std::uint64_t index = 0;
  PartClass parts = PartClasses::none;  // as of_tree
  ShapeCursor cursor;                   // where there is no list
};

class ListedShapes {
 public:
  // Of some 200 bytes each.
  static constexpr std::uint64_t default_longest = 16384;

  // Keeps the classes, which have to outlive it. counts[size]: how many shapes there are.
  ListedShapes(const PartClasses& classes, const PartSet& parts,
               const std::vector<std::uint64_t>& counts,
               std::uint64_t longest_list = default_longest);

  std::uint64_t count(int size) const { return counts_[static_cast<std::size_t>(size)]; }

  // False if there is none.
  bool start(ListedShape& shape, int size) const;
  bool next(ListedShape& shape) const;
  // Steps on to this index, which is not before its own and below the count.
  void advance_to(ListedShape& shape, std::uint64_t index) const;
  const Tendon& tendon(const ListedShape& shape) const;

  // Of all the shapes of this size from that index on.
  ClassCounts counts_from(int size, std::uint64_t index) const;

 private:
  struct List {
    std::vector<Tendon> tendons;
    std::vector<PartClass> parts;
  };

  const List* list(int size) const;
  PartClass parts_of(const Tendon& tendon) const { return classes_.of_tree(classes_.of(tendon)); }

  const PartClasses& classes_;
  PartSet parts_;
  std::vector<std::uint64_t> counts_;
  std::vector<List> lists_;  // [size]; empty: none
};

}  // namespace reeve::search
