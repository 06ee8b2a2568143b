#include "search/evaluate/known_trees.hpp"

#include <algorithm>

namespace reeve::search {

KnownTrees::KnownTrees(const Hardware& hardware, std::size_t sets)
    : tendon_sums_(hardware), solver_(hardware), table_(sets * ways) {}

void KnownTrees::solve(const Routing& routing, const TreeSpan& span, Place& place) {
  copy_tree(routing, span, tree_);
  solver_.solve(tree_, place.states);
  place.solved = true;
  ++solved_;
}

void KnownTrees::outline(const Routing& routing, const TreeSpan& span, Place& place) {
  place.key = span.key;
  place.solved = false;
  if (!tendon_sums_.find(routing, span, place.states.outline)) solve(routing, span, place);
}

// Nothing where all places of this hash are of this routing.
KnownTrees::Place* KnownTrees::find(const Routing& routing, const TreeSpan& span) {
  const std::size_t set = hash(span.key) & (table_.size() / ways - 1);
  Place* const first = &table_[set * ways];
  Place* found = first;
  for (Place* place = first; place != first + ways; ++place) {
    if (place->asked > 0 && place->key == span.key) {
      place->asked = now_;
      return place;
    }
    if (place->asked < found->asked) found = place;
  }
  if (found->asked == now_) return nullptr;
  outline(routing, span, *found);
  found->asked = now_;
  return found;
}

bool KnownTrees::find(const Routing& routing, const std::vector<TreeSpan>& spans) {
  ++now_;
  found_.clear();
  const int fingers = spans.back().fingers_before + spans.back().fingers;
  for (const TreeSpan& span : spans) {
    Place* place = &greatest_;
    if (2 * span.fingers <= fingers + 1) {
      place = find(routing, span);
    } else if (greatest_.asked == 0 || greatest_.key != span.key) {
      outline(routing, span, greatest_);
      greatest_.asked = now_;
    }
    if (place == nullptr) return false;
    found_.push_back(place);
  }
  return true;
}

const std::vector<const TreeOutline*>& KnownTrees::outlines(const Routing& routing,
                                                            const std::vector<TreeSpan>& spans) {
  outlines_.clear();
  if (!find(routing, spans)) return outlines_;
  for (const Place* place : found_) outlines_.push_back(&place->states.outline);
  return outlines_;
}

const std::vector<const SolvedTrees*>& KnownTrees::states(const Routing& routing,
                                                          const std::vector<TreeSpan>& spans) {
  states_.clear();
  if (!find(routing, spans)) return states_;
  for (std::size_t t = 0; t < spans.size(); ++t) {
    if (!found_[t]->solved) solve(routing, spans[t], *found_[t]);
    states_.push_back(&found_[t]->states);
  }
  return states_;
}

}  // namespace reeve::search
