// The sets of trees that TreeDecoder and TreeSets read from an index, with the parts of each: the
// same choices in the same order (enumerate/tree_index.cpp, tree_sets.cpp), for identical fingers.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "search/enumerate/tree_counts.hpp"
#include "search/limits/numbered_parts.hpp"

namespace reeve::search {

class TreeParts {
 public:
  // Keeps the classes.
  TreeParts(const PartClasses& classes, const PartSet& parts, int fingers);

  // Sets of trees with a block each that have this size in all, or such trees alone.
  NumberedParts::Sort sets(TreeSize size);
  NumberedParts::Sort tree(TreeSize size);

  NumberedParts& numbered() { return numbered_; }

 private:
  using Sort = NumberedParts::Sort;
  using Sizes = std::map<std::pair<int, int>, Sort>;

  // Looks the sort of this size up, and makes it the first time.
  template <typename Make>
  Sort known(Sizes& sizes, int first, int second, Make make);

  Sort tips();
  Sort joins();
  Sort ends();
  Sort string(int m);
  Sort to_end(int m);
  Sort middle(int m);
  Sort mirrored_half(int m);
  Sort loop_through_pass(int m);
  Sort half(TreeSize size);
  Sort tailed_half(TreeSize size);
  Sort side(TreeSize size);
  Sort double_pass(TreeSize of_branch);
  Sort branch(TreeSize size);
  Sort beads_before(int passes);
  Sort riser(TreeSize size);
  Sort arm(int passes, TreeSize size);
  Sort beaded(int passes, TreeSize size);
  template <typename Others>
  Sort beside_risers(TreeSize size, Others others);
  Sort in_series(int passes, TreeSize size);
  template <typename Member>
  void append_pairs(TreeSize size, Member member, std::vector<Sort>& pairs);
  template <typename Member>
  Sort about_string(int m, TreeSize size, Member member);
  Sort sets_from(std::size_t first, TreeSize size);

  const PartClasses& classes_;
  PartSet parts_;
  NumberedParts numbered_;
  std::vector<TreeSize> sizes_;  // sizes that have trees, as in TreeSets
  Sort nothing_ = 0;             // there is none of it
  Sort empty_ = 0;               // there is one of it, without parts
  Sizes strings_;
  Sizes to_ends_;
  Sizes mirrored_;
  Sizes halves_;
  Sizes sides_;
  Sizes branches_;
  Sizes risers_;
  std::map<int, Sizes> arms_;  // by their number of passes
  Sizes trees_;
  std::map<std::pair<std::size_t, std::pair<int, int>>, Sort> sets_;
};

}  // namespace reeve::search
