// Quantiles of Student's t distribution: of a normal number over a standard deviation that was
// estimated from as many degrees of freedom.
#pragma once

#include "numerics/floors.hpp"

namespace reeve::numerics {

// Below which the number is with this probability. degrees_of_freedom > 0, need not be whole.
double student_t_quantile(double probability, double degrees_of_freedom);

}  // namespace reeve::numerics
