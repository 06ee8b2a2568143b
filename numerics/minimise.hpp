// Minimising a function of a few bounded variables that need not be smooth or convex.
#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::numerics {

struct Interval {
  double low = 0;
  double high = 0;  // may equal low: that variable is fixed
};

struct Minimum {
  std::vector<double> at;
  double value = 0;
};

// Divides the box (DIRECT-L, J. M. Gablonsky, C. T. Kelley, 2001), then refines the best point
// (Subplex, T. H. Rowan, 1990), with at most `evaluations` calls for each. Deterministic; the least
// value that was seen, which for a function with narrow valleys need not be the least there is.
// Exceptions of the function come through; std::domain_error if it has no finite value there. Once
// `stop` is set, if there is one, it ends with what it has seen.
Minimum minimise(const std::function<double(const std::vector<double>&)>& function,
                 const std::vector<Interval>& box, int evaluations,
                 const std::atomic<bool>* stop = nullptr);

// The second half of it alone, from a starting point in the box: its first steps are a quarter of
// the box, so that a shallow valley does not hold it. It ends where its steps are less than this
// part of the box's sides.
Minimum descend(const std::function<double(const std::vector<double>&)>& function,
                const std::vector<Interval>& box, const std::vector<double>& start, int evaluations,
                double tolerance = 1e-9, const std::atomic<bool>* stop = nullptr);

// Refines a starting point in the box by quadratic models (BOBYQA, M. J. D. Powell, 2009): for
// smooth functions. The least value that was seen; otherwise as above.
Minimum refine(const std::function<double(const std::vector<double>&)>& function,
               const std::vector<Interval>& box, const std::vector<double>& start, int evaluations,
               double tolerance = 1e-7);

}  // namespace reeve::numerics
