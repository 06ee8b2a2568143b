// Student's t distribution: of a normal number over its standard deviation, estimated from as many
// degrees of freedom.
#pragma once

#include "numerics/floors.hpp"

namespace reeve::numerics {

// Returns the quantile of this probability. degrees_of_freedom > 0, need not be whole.
double student_t_quantile(double probability, double degrees_of_freedom);

// Probability that the number is at least t away from 0. t >= 0, may be infinite.
double two_sided_p_value(double t, double degrees_of_freedom);

}  // namespace reeve::numerics
