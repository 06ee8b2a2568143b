// Good designs of a long search, found before it begins. What they dominate is left out.
//
// They are the best of the parts with little friction. Most of the best of all are among them, and
// the whole enumeration begins with the worst: one tendon, round tubes.
#pragma once

#include <atomic>

#include "search/exploration_part.hpp"

namespace reeve::search {

class ForeseenDesigns {
 public:
  // Searches for them; finds fewer if stopped.
  ForeseenDesigns(const ExploreOptions& options, const std::atomic<bool>* stop);

  const Visited& visited() const { return found_.visited; }

  // False if designs of these values are left out.
  bool may_keep(const ObjectiveValues& values) const { return found_.may_keep(values); }

  // Adds them to what a search kept that was stopped before it came to them, so that the designs
  // that were left out for them are not missed.
  void add_to(ExplorationPart& stopped);

 private:
  ExplorationPart found_;
};

}  // namespace reeve::search
