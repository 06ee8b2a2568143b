// How far the ratios of a tension to the load, q = T / T_load, are from their forecasts by noise.
//
// A sensor scatters by so many newton whatever it reads, and what drives it, by a share of it, so
// that a forecast of T is off by a standard deviation of
//
//   s² = a² + b² T²
//
// and that of q by s / T_load. A strand that reads far less while the carriage pulls than while it
// releases thus has other relative noise in each. The two parts follow from the third of the
// forecasts with the least tensions and that with the greatest; where these are hardly apart, from
// all as a. Below the lower third s is taken for no less than there: the data do not say.
#pragma once

#include <vector>

#include "numerics/floors.hpp"

namespace reeve::readings {

struct ForecastError {
  double tension_N = 0;  // as it mostly is over the stretch
  double error_N = 0;
};

struct RatioNoise {
  double least_tension_N = 0;  // that the data speak of
  double absolute_N = 0;       // a
  double relative = 0;         // b

  double at(double tension_N) const;  // s
};

RatioNoise ratio_noise(std::vector<ForecastError> errors);

}  // namespace reeve::readings
