// Minimising a sum of squares of smooth residuals in a box (K. Levenberg, Quart. Appl. Math. 2,
// 1944; D. W. Marquardt, J. SIAM 11, 1963): each step solves
//
//   (JᵀJ + λ diag JᵀJ) δ = −Jᵀ r
//
// for the variables that are not held at a bound, J by one-sided differences; λ falls where a step
// succeeds and rises where it fails.
//
// Where many starts are only to be compared, J is worked out once and corrected by what each step δ
// changed (C. G. Broyden, Mathematics of Computation 19, 1965),
//
//   J ← J + (Δr − J δ) δᵀ / δᵀδ   (δ in widths of the box),
//
// and worked out anew where no step leads on.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "numerics/minimise.hpp"

namespace reeve::numerics {

// Returns nothing if there are no residuals at the point.
using Residuals = std::function<std::optional<Eigen::VectorXd>(const std::vector<double>&)>;

struct LeastSquares {
  Minimum minimum;
  // Otherwise no step led on from where the residuals still fall: they may not be smooth there.
  bool converged = false;
};

enum class Precision : std::uint8_t { full, to_compare };

// Minimises from a starting point in the box; the value is infinite if there are no residuals
// there. The search to compare ends where a step lowers the sum by less than a ten thousandth.
LeastSquares least_squares(const Residuals& residuals, const std::vector<Interval>& box,
                           const std::vector<double>& start, Precision precision = Precision::full);

}  // namespace reeve::numerics
