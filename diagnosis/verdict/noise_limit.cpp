#include "diagnosis/verdict/noise_limit.hpp"

#include <cmath>

#include "numerics/chi_squared.hpp"

namespace reeve::diagnosis {

NoiseLimit noise_limit(const Problem& held_out, const Model& before) {
  const Forecast at = forecast(*held_out.dataset, before);
  const double misfit = residuals(held_out, at).squaredNorm();
  const double degrees = held_out.dataset->degrees_of_freedom();
  NoiseLimit limit;
  limit.log_likelihood_gain = (misfit - degrees) / 2;
  limit.low = (misfit - chi_squared_quantile(0.975, degrees)) / 2;
  limit.high = (misfit - chi_squared_quantile(0.025, degrees)) / 2;
  const auto cells = static_cast<double>(held_out.deviation_N.size());
  limit.rms_N = std::sqrt(noise_variance(held_out, at).sum() / cells);
  return limit;
}

}  // namespace reeve::diagnosis
