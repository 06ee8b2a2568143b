#include "numerics/binomial.hpp"

#include <boost/math/special_functions/beta.hpp>

namespace reeve::numerics {

ConfidenceInterval binomial_interval(std::size_t successes, std::size_t trials, double confidence) {
  const auto k = static_cast<double>(successes);
  const auto n = static_cast<double>(trials);
  const double tail = (1 - confidence) / 2;
  return {successes == 0 ? 0 : boost::math::ibeta_inv(k, n - k + 1, tail),
          successes == trials ? 1 : boost::math::ibetac_inv(k + 1, n - k, tail)};
}

double at_least_so_many(std::size_t successes, std::size_t trials, double probability) {
  if (successes == 0) return 1;
  if (successes > trials) return 0;
  const auto k = static_cast<double>(successes);
  return boost::math::ibeta(k, static_cast<double>(trials) - k + 1, probability);
}

}  // namespace reeve::numerics
