// How far all dimensions may be off at once.
//
// Alone, variable i may be off by less_i and more_i (tolerance.hpp). Where one of them has no end,
// the other counts for it, since parts are made to ±; where neither has, a tenth of the width of
// the bounds does. Together they make the box
//
//   x_i − k less_i … x_i + k more_i
//
// and the common factor k is the greatest, at most 1, for which no point of it loses more than what
// is tolerated. It is searched from above: corner by corner (all of them of up to eight variables,
// of more those that an ascent reaches which turns one variable at a time), then anywhere in the
// box (DIRECT-L and Subplex); where a point loses too much, the box shrinks along the ray to it
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
