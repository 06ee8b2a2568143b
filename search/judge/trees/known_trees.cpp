#include "search/judge/trees/known_trees.hpp"

#include <algorithm>

namespace reeve::search {

KnownTrees::KnownTrees(const Hardware& hardware, std::size_t sets)
    : solver_(hardware), table_(sets * ways) {}

const TreeStates* KnownTrees::solve(const Routing& routing, const TreeSpan& span, Place& place) {
  copy_tree(routing, span, tree_);
  solver_.solve(tree_, place.states);
  place.key = span.key;
  place.asked = now_;
  ++solved_;
  return &place.states;
}

const TreeStates* KnownTrees::states(const Routing& routing, const TreeSpan& span) {
  const std::size_t set = hash(span.key) & (table_.size() / ways - 1);
  Place* const first = &table_[set * ways];
  Place* oldest = first;
  for (Place* place = first; place != first + ways; ++place) {
    if (place->asked > 0 && place->key == span.key) {
      place->asked = now_;
      return &place->states;
    }
    if (place->asked < oldest->asked) oldest = place;
  }
  // All of them are of this routing.
  if (oldest->asked == now_) return nullptr;
  return solve(routing, span, *oldest);
}

const std::vector<const TreeStates*>& KnownTrees::states(const Routing& routing,
                                                         const std::vector<TreeSpan>& spans) {
  ++now_;
  found_.clear();
  const int fingers = spans.back().fingers_before + spans.back().fingers;
  for (const TreeSpan& span : spans) {
    const TreeStates* known = nullptr;
    if (2 * span.fingers <= fingers + 1) {
      known = states(routing, span);
    } else if (greatest_.asked > 0 && greatest_.key == span.key) {
      known = &greatest_.states;
    } else {
      known = solve(routing, span, greatest_);
    }
    if (known == nullptr) {
      found_.clear();
      return found_;
    }
    found_.push_back(known);
  }
  return found_;
}

}  // namespace reeve::search
