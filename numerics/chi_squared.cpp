#include "numerics/chi_squared.hpp"

#include <boost/math/special_functions/gamma.hpp>

namespace reeve::numerics {

double chi_squared_quantile(double probability, double degrees_of_freedom) {
  if (degrees_of_freedom <= 0) return 0;
  return 2 * boost::math::gamma_p_inv(degrees_of_freedom / 2, probability);
}

}  // namespace reeve::numerics
