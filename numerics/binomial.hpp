// Confidence interval and tail probability of a share of successes.
#pragma once

#include <cstddef>

#include "numerics/floors.hpp"

namespace reeve::numerics {

struct ConfidenceInterval {
  double low = 0;
  double high = 0;
};

// The interval of C. J. Clopper and E. S. Pearson (Biometrika 26, 1934), which covers the
// probability with at least this confidence; 0 to 1 without trials.
ConfidenceInterval binomial_interval(std::size_t successes, std::size_t trials,
                                     double confidence = 0.95);

// Returns the probability that at least `successes` of the independent trials succeed.
double at_least_so_many(std::size_t successes, std::size_t trials, double probability);

}  // namespace reeve::numerics
