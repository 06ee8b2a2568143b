#include "numerics/student_t.hpp"

#include <boost/math/distributions/students_t.hpp>

namespace reeve::numerics {

double student_t_quantile(double probability, double degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), probability);
}

}  // namespace reeve::numerics
