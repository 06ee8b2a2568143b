// Counts dominators for at most two objectives, in O(log n) a row, of rows that come best first:
// whatever came before a row is no worse in the first objective, so that only second values need to
// be counted.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::search {

class SweepCounter {
 public:
  // All second values that will come.
  explicit SweepCounter(std::vector<double> values);

  void add(double value);
  // Values added so far that are not less.
  Eigen::Index not_less(double value) const;

 private:
  std::size_t rank(double value) const;  // from 1, the greatest first

  std::vector<double> falling_;
  std::vector<Eigen::Index> sums_;  // a Fenwick tree over the ranks (P. Fenwick, 1994)
};

}  // namespace reeve::search
