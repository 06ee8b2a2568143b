// Proof, in O(log n), that at least k of n rows dominate a candidate, for at most three objectives.
//
// Of rows sorted by falling first value, the k-th greatest second value of those down to a row,
//
//   d_k(a) = k-th greatest of { second : first >= a },
//
// is a staircase that climbs as a falls; for k = 1 it is the Pareto front. A candidate (a, b) has k
// rows that are no worse if d_k(a) >= b, and k that dominate it if one of both is strict. Where a
// third objective takes few values, there is a staircase for each of them, of the rows that have at
// least as much (H. Kung, F. Luccio, F. Preparata, J. ACM 22, 1975, for the front of three).
//
// It may fail to prove what is true: rows that are strictly better in one objective and others that
// are in another are not counted together. For k = 1 it is exact, but where the second value is −∞
// (of a cost that is infinite): there it proves nothing.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <queue>
#include <vector>

#include "numerics/floors.hpp"
#include "search/rank/pareto.hpp"

namespace reeve::search {

// The k greatest of the values that were added.
//
// It counts dominators for at most two objectives, of rows that come best first: whatever came
// before a row is no worse in the first objective, so that only second values need to be counted.
class KGreatest {
 public:
  // keep >= 1
  explicit KGreatest(std::size_t keep) : keep_(keep) {}

  void add(double value);
  // The least of them; −∞ if fewer were added.
  double least() const;
  // True if there are k, none less than this value.
  bool has_all_above(double value) const;

 private:
  std::size_t keep_;
  std::priority_queue<double, std::vector<double>, std::greater<>> heap_;
};

class Staircase {
 public:
  // No rows: proves nothing.
  Staircase() = default;
  // Takes the rows in any order.
  Staircase(const GoodnessMatrix& rows, std::size_t keep);

  // True if there are at most three objectives, and few values of the third.
  static bool can_hold(const GoodnessMatrix& rows);

  bool proves_dominators(const Goodness& candidate) const;

 private:
  struct Step {
    double first;
    double depth;  // d_k from this step down to the next one
  };
  // Staircase of the rows whose value on the third axis is at least `least`.
  struct Layer {
    double least;
    std::vector<Step> steps;  // sorted by falling first value
  };

  void choose_axes(const GoodnessMatrix& rows);
  double at(const Goodness& candidate, Eigen::Index axis) const;

  Eigen::Index first_ = 0;
  Eigen::Index second_ = -1;  // -1: no such objective, all are 0
  Eigen::Index third_ = -1;
  std::vector<Layer> layers_;  // sorted by falling value
};

}  // namespace reeve::search
