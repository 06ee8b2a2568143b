// Readings of one quantity that differ by more than they can be read to, and their mean.
#pragma once

#include <vector>

#include "catalog/published.hpp"

namespace reeve::catalog {

// The mean of at least two readings with the standard deviation s, written with the two digits that
// its tolerance tells. The tolerance is half the 95 % confidence interval, t s/√n with Student's t
// of n - 1 degrees of freedom, or the rounding of a reading if that is more. Assumes independent,
// normal readings.
PrintedNumber mean_of(const std::vector<PrintedNumber>& trials);

// The readings, each with half the 95 % prediction interval, t s √(1 + 1/n), as its tolerance: one
// reading more of the same quantity would lie within it of their mean.
std::vector<PrintedNumber> with_scatter(std::vector<PrintedNumber> trials);

}  // namespace reeve::catalog
