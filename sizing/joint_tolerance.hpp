// Joint tolerance: allowed deviation of all dimensions at once.
//
// Alone, variable i may deviate by less_i and more_i (tolerance.hpp). If one of them has no limit,
// the other counts for both, since parts are made to ±. If neither has, a tenth of the width of the
// bounds counts. Together they make the box
//
//   x_i − k less_i … x_i + k more_i
//
// The common factor k is the greatest, at most 1, for which no point of the box loses more than is
// tolerated. The search goes from above, first through the corners: all of them for up to eight
// variables, else those that an ascent reaches by changing one variable at a time. Then it searches
// the box (DIRECT-L and Subplex). If a point loses too much, the box shrinks along the ray to it
// until it does not. A point that none of these finds would make k smaller.
#pragma once

#include <cstdint>
#include <vector>

#include "sizing/tolerance.hpp"

namespace reeve::sizing {

struct JointTolerance {
  struct Ways {
    double less = 0;
    double more = 0;
  };

  double factor = 1;
  std::vector<Ways> ways;     // k less_i, k more_i
  std::vector<double> worst;  // moves of the variables that lose what is tolerated; {} if k is 1
};

JointTolerance joint_tolerance(const SizingProblem& problem, const Goal& goal,
                               const SizingPoint& point, const std::vector<Sensitivity>& alone,
                               std::uint64_t drawn_by);

}  // namespace reeve::sizing
