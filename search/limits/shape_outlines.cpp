#include "search/limits/shape_outlines.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::search {

ShapeOutlines::ShapeOutlines(const Hardware& hardware, ListedShapes& shapes, int fingers)
    : shapes_(shapes),
      tendon_sums_(hardware),
      short_(1),
      most_efficiency_(std::exp(-hardware.sheath.exponent())) {
  most_motor_.resize(static_cast<std::size_t>(fingers) + 1);
  for (int size = 1; 2 * size <= fingers; ++size) look_at_size(size);
}

// The only finger of a tendon is never said to be held: it then jams, pulls nothing, and leaves the
// others slack.
bool ShapeOutlines::outline(const ListedShape& shape, TreeOutline& outline) {
  const int held = shape.size == 1 ? 0 : shape.size;
  if (tendon_sums_.find(shapes_.tendon(shape), held, outline)) return true;
  outline.sums.clear();
  return false;
}

void ShapeOutlines::look_at_size(int size) {
  double most = 0;
  std::vector<TreeOutline>& known = short_.emplace_back();
  ListedShape shape;
  for (bool found = shapes_.start(shape, size); found; found = shapes_.next(shape)) {
    outline(shape, known.emplace_back());
    for (const TreeSums& sums : known.back().sums) most = std::max(most, sums.motor);
  }
  for (auto n = static_cast<std::size_t>(size); n < most_motor_.size(); ++n) {
    const double with_it = most_motor_[n - static_cast<std::size_t>(size)] + most;
    most_motor_[n] = std::max(most_motor_[n], with_it);
  }
}

const TreeOutline* ShapeOutlines::find_bound(const ListedShape& shape) {
  constexpr int few = 1;
  if (!tendon_sums_.find(shapes_.tendon(shape), few, bound_)) return nullptr;
  TreeSums at_best;
  at_best.motor = 1;
  at_best.strands.add(1, most_efficiency_);
  bound_.sums.resize(static_cast<std::size_t>(shape.size) + 1, at_best);
  return &bound_;
}

const TreeOutline* ShapeOutlines::find(const ListedShape& shape) {
  const auto size = static_cast<std::size_t>(shape.size);
  const bool is_short = size < short_.size();
  if (!is_short && (of_long_.size != shape.size || of_long_.index != shape.index)) {
    of_long_.size = shape.size;
    of_long_.index = shape.index;
    outline(shape, long_);
  }
  const TreeOutline& found = is_short ? short_[size][shape.index] : long_;
  return found.sums.empty() ? nullptr : &found;
}

}  // namespace reeve::search
