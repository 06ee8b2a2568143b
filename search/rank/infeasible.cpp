#include "search/rank/infeasible.hpp"

#include <algorithm>

namespace reeve::search {

void Nearest::add(double value, double bound) {
  if (value >= bound) above = above ? std::min(*above, value) : value;
  if (value <= bound) below = below ? std::max(*below, value) : value;
}

void Nearest::add(const Nearest& other) {
  if (other.above) above = above ? std::min(*above, *other.above) : other.above;
  if (other.below) below = below ? std::max(*below, *other.below) : other.below;
}

void ConstraintReaches::add(const std::vector<Constraint>& constraints,
                            const ObjectiveValues& values) {
  const auto failures = std::count_if(constraints.begin(), constraints.end(),
                                      [&](const Constraint& c) { return !c.admits(values); });
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    const Constraint& constraint = constraints[c];
    if (constraint.admits(values)) {
      reaches_[c].met = true;
      continue;
    }
    const double given = value(values, constraint.objective);
    reaches_[c].of_all.add(given, constraint.bound);
    if (failures == 1) reaches_[c].of_those_that_meet_the_others.add(given, constraint.bound);
  }
}

void ConstraintReaches::add(const ConstraintReaches& others) {
  for (std::size_t c = 0; c < reaches_.size(); ++c) {
    const ConstraintReach& other = others.reaches_[c];
    reaches_[c].met = reaches_[c].met || other.met;
    reaches_[c].of_all.add(other.of_all);
    reaches_[c].of_those_that_meet_the_others.add(other.of_those_that_meet_the_others);
  }
}

}  // namespace reeve::search
