// The designs that can still be among the best, out of a stream of any length.
//
// A design that at least `keep` others beat (dominate it, or equal it in the chosen objectives and
// precede it within the front) cannot be among the first `keep` of the ranking: each of them comes
// before it. The designs that fewer beat (the keep-skyband) are all that is held. They suffice for
// the exact fronts too, since whatever dominates a member is a member or is itself dominated by
// enough members. The front is whole, but for designs beyond the first `keep` of those that are
// equal in all chosen objectives: these are only counted.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "search/rank/pareto.hpp"
#include "search/rank/ranking.hpp"
#include "search/rank/staircase.hpp"

namespace reeve::search {

// A kept design, and the number of equal ones that were left out for it.
struct ArchivedDesign {
  Design design;
  std::uint64_t equals_left_out = 0;
};

class Archive {
 public:
  // keep >= 1
  Archive(Order order, std::size_t keep);

  // False if enough designs are known to beat these values; may be asked from many threads.
  bool may_rank(const ObjectiveValues& values) const;

  void add(Design design, std::uint64_t equals_left_out = 0);

  // Returns the designs that another archive needs to rank these and its own as this one would.
  std::vector<ArchivedDesign> members();

  struct Content {
    std::vector<RankedDesign> ranked;  // best first; at least the first `keep` and the front
    std::uint64_t front_equals_left_out = 0;
  };
  Content content() &;
  Content content() &&;  // needs no second copy of the designs

  std::size_t held() const { return entries_.size(); }

 private:
  struct Entry {
    Design design;
    Goodness goodness;
    std::uint64_t equals_left_out = 0;
  };

  // An entry is much larger than what points to it.
  using Place = std::unique_ptr<Entry>;

  Content ranked_content(std::vector<Design> designs) const;
  bool has_enough_dominators(Eigen::Index rows, const Goodness& candidate,
                             Eigen::Index beaten) const;
  bool sweeps() const { return order_.objectives.size() <= 2; }
  void sort_entries();
  void compact();
  void place_guards();
  void place_corner();

  Order order_;
  std::size_t keep_;
  std::vector<Place> entries_;  // the first compacted_ are sorted and thinned out
  std::size_t compacted_ = 0;
  GoodnessMatrix guards_;  // values of the compacted entries
  Staircase staircase_;    // staircase of the guards, if it can hold them …
  bool climbs_ = false;
  Goodness corner_;  // … otherwise `keep` guards dominate whatever is worse in everything
};

}  // namespace reeve::search
