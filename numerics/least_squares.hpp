// Minimising a sum of squares of smooth residuals in a box (K. Levenberg, Quart. Appl. Math. 2,
// 1944; D. W. Marquardt, J. SIAM 11, 1963): each step solves
//
//   (JᵀJ + λ diag JᵀJ) δ = −Jᵀ r
//
// for the variables that are not held at a bound, J by one-sided differences; λ falls where a step
// succeeds and rises where it fails.
#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

#include "numerics/minimise.hpp"

namespace reeve::numerics {

// Nothing where there are no residuals.
using Residuals = std::function<std::optional<Eigen::VectorXd>(const std::vector<double>&)>;

struct LeastSquares {
  Minimum minimum;
  // Otherwise no step led on from where the residuals still fall: they may not be smooth there.
  bool converged = false;
};

// From a starting point in the box; its value is infinite if there are no residuals there.
LeastSquares least_squares(const Residuals& residuals, const std::vector<Interval>& box,
                           const std::vector<double>& start);

}  // namespace reeve::numerics
