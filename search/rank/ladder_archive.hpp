// The designs that can be a rung of the ladder (ladder.hpp), out of a stream of any length.
//
// Exact: a design that another one with as little of the measure matches or beats in every ranked
// objective is no rung, however long the ladder. What is kept is one Pareto front, so that memory
// does not grow with the number of designs that are offered; it is kept beside the archive of the
// ranking, in which the best design with one sheath may be far beyond the end.
#pragma once

#include <vector>

#include "search/rank/archive.hpp"

namespace reeve::search {

class LadderArchive {
 public:
  LadderArchive(const Order& order, Objective by);

  // May be asked from many threads.
  bool may_be_rung(const ObjectiveValues& values) const { return archive_.may_rank(values); }

  void add(Design design);

  std::vector<Design> candidates();

 private:
  Archive archive_;
};

}  // namespace reeve::search
