// Trees that were solved before, as many as a table of fixed size holds.
//
// Each hash has a set of four places, of which the one that was not asked for longest makes room:
// memory is bounded, and what is not found is solved again, to the same figures. A tree with more
// than half of a routing's fingers has a place of its own beside the table: there are many of them,
// and in the order in which routings are generated one stays while all others beside it change.
#pragma once

#include <cstdint>
#include <vector>

#include "search/judge/trees/tree_spans.hpp"
#include "search/judge/trees/tree_states.hpp"

namespace reeve::search {

class KnownTrees {
 public:
  static constexpr std::size_t default_sets = 2048;

  // `sets` is a power of two.
  explicit KnownTrees(const Hardware& hardware, std::size_t sets = default_sets);

  // The states of these trees of a routing, valid until the next call; nothing where more trees
  // than there are places share a hash.
  const std::vector<const TreeStates*>& states(const Routing& routing,
                                               const std::vector<TreeSpan>& spans);

  // Trees solved so far.
  std::uint64_t solved() const { return solved_; }

 private:
  static constexpr std::size_t ways = 4;

  struct Place {
    TreeKey key;
    std::uint64_t asked = 0;  // when it was last; 0: it is empty
    TreeStates states;
  };

  const TreeStates* states(const Routing& routing, const TreeSpan& span);
  const TreeStates* solve(const Routing& routing, const TreeSpan& span, Place& place);

  TreeSolver solver_;
  Routing tree_;
  Place greatest_;
  std::vector<Place> table_;
  std::uint64_t now_ = 0;
  std::uint64_t solved_ = 0;
  std::vector<const TreeStates*> found_;
};

}  // namespace reeve::search
