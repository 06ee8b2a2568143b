#include "numerics/student_t.hpp"

#include <boost/math/distributions/students_t.hpp>

namespace reeve::numerics {

double student_t_quantile(double probability, double degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), probability);
}

double two_sided_p_value(double t, double degrees_of_freedom) {
  const boost::math::students_t distribution(degrees_of_freedom);
  return 2 * boost::math::cdf(boost::math::complement(distribution, t));
}

}  // namespace reeve::numerics
