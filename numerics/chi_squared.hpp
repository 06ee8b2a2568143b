// Quantiles of the chi-squared distribution: of a sum of squared standard normal numbers.
#pragma once

#include "numerics/floors.hpp"

namespace reeve::numerics {

// Below which the sum is with this probability; 0 without degrees of freedom.
double chi_squared_quantile(double probability, double degrees_of_freedom);

}  // namespace reeve::numerics
