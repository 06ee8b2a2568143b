// The sums of tendons in all their states, by their shapes, as beginnings of routings need them
// (evaluate/routing_beginning.hpp).
#pragma once

#include <vector>

#include "core/hardware.hpp"
#include "search/evaluate/tendon_sums.hpp"
#include "search/limits/listed_shapes.hpp"

namespace reeve::search {

class ShapeOutlines {
 public:
  // Keeps a reference to the shapes. Routings have at most so many fingers.
  ShapeOutlines(const Hardware& hardware, ListedShapes& shapes, int fingers);

  // Returns nothing if it jams in a state, or if no motor pulls it. Keeps one of the shapes with
  // more than half of the fingers.
  const TreeOutline* find(const ListedShape& shape);

  // Returns sums that bound those of a shape in no list, of few of its states.
  const TreeOutline* find_bound(const ListedShape& shape);

  // The greatest motor tension, in any state, of tendons that pass so many fingers in all, each at
  // most half of those of a routing.
  double most_motor_tension(int fingers) const {
    return most_motor_[static_cast<std::size_t>(fingers)];
  }

 private:
  void look_at_size(int size);
  bool outline(const ListedShape& shape, TreeOutline& outline);

  ListedShapes& shapes_;
  TendonSums tendon_sums_;
  std::vector<std::vector<TreeOutline>> short_;  // [size][index], without sums where there are none
  TreeOutline long_;
  TreeOutline bound_;
  double most_efficiency_;
  ListedShape of_long_;
  std::vector<double> most_motor_;  // [fingers]
};

}  // namespace reeve::search
