// Bands of a design's objectives under drawn coefficients: median, 5 % and 95 % quantile.
//
// The value of a draw is the objective over all grasps of the ranking, at that draw's coefficients.
// Quantiles are those of `size` (numerics/robust.hpp), with linear interpolation between two draws.
#pragma once

#include <cstddef>
#include <vector>

#include "numerics/parallel.hpp"
#include "search/evaluate/objectives.hpp"
#include "search/rank/ranking.hpp"

namespace reeve::search {

struct Band {
  double median = 0;
  double low = 0;   // 5 % quantile
  double high = 0;  // 95 % quantile

  bool is_point() const { return low == high; }
};

struct ObjectiveBand {
  Objective objective{};
  Band band;
};

// Bands of one design, in the order of the table of objectives. Empty without draws.
using Bands = std::vector<ObjectiveBand>;

const Band* find_band(const Bands& bands, Objective objective);

// True if friction changes the objective, so that draws make a band of it. Numbers of parts and
// finger and carriage positions do not depend on friction. Quantiles over contacts already come
// from draws.
bool depends_on_friction(Objective objective);

// Returns the objectives that depend on friction, of hardware with or without a hand.
std::vector<Objective> friction_objectives(bool with_hand);

// Infinite values are the worst or the best, as they are; none is NaN.
Band band_of(const std::vector<double>& values);

// Values of the designs `begin` to `end` of a list in each draw, from which their bands are made,
// and what orders designs within a front (decisive_value).
class DrawnValues {
 public:
  DrawnValues(std::vector<Objective> objectives, Order order, std::size_t draws, std::size_t begin,
              std::size_t end);

  std::size_t begin() const { return begin_; }
  std::size_t end() const { return end_; }
  // Does nothing for designs that are not kept here. Each draw of each design once, from any
  // thread.
  void keep(std::size_t design, std::size_t draw, const ObjectiveValues& values);
  // Return the bands of the designs kept, in their order.
  std::vector<Bands> bands(Workers& workers) const;
  std::vector<Band> decisive_bands(Workers& workers) const;

 private:
  std::vector<Objective> objectives_;
  Order order_;
  std::size_t draws_;
  std::size_t begin_;
  std::size_t end_;
  std::vector<double> values_;    // [design][objective][draw]
  std::vector<double> decisive_;  // [design][draw]
};

}  // namespace reeve::search
