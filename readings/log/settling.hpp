// From where on all contacts slide, within a stretch in which the carriage moves evenly.
//
// After a turn or a rest the contacts begin to slide one after another. Until then the tensions
// come nearer to their ratios; from then on the ratios to the load, q = T / T_load, go on as they
// went, whether the load stays or grows (T_load: motor tension, or the sum of the tensions). So the
// stretch is walked backwards from its end, as long as every q goes on along the straight line
// through the least time behind, to within
//
//   tolerance · median q + 4 s / T_load
//
// with s the deviation of such forecasts in newton over all stretches of the log that have such a
// tension (RatioNoise), and more of it the farther the forecast. Two blocks off the line in a
// row end the walk, and so do the third to the fifth together, as where q bends slowly; a single
// one is passed over. The first block of what is left may hold the last contact's start, and is
// left out too. Idea: the settling time of control engineering, about a trend instead of a level.
//
// The stretch is looked at in 50 blocks at most, since a bend is as slow as the carriage. What is
// found must follow the load: from its first to its last third q changes by no more than that much
// and half of ln of what the load grows by; where a contact sticks, T stays and ln q falls by all
// of it.
#pragma once

#include <cstddef>
#include <vector>

#include "readings/log/recordings.hpp"

namespace reeve::readings {

struct ForecastError {
  double tension_N = 0;  // as it mostly is over the stretch
  double error_N = 0;
};

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
struct RatioNoise {
  double least_tension_N = 0;  // that the data speak of
  double absolute_N = 0;       // a
  double relative = 0;         // b

  double at(double tension_N) const;  // s
};

RatioNoise ratio_noise(std::vector<ForecastError> errors);

// Of the forecasts that the walk makes, one for each tension.
std::vector<RatioNoise> forecast_noise(const std::vector<std::vector<SeriesBlock>>& recordings,
                                       const std::vector<std::vector<BlockStretch>>& stretches);

struct SettledPart {
  std::size_t from = 0;  // block of the stretch; its end if none is settled
  // Tensions that stay where the load grows or falls, so that it is none: a contact may stick, or
  // a sensor be at the end of its range or far from its zero.
  std::vector<std::size_t> staying;
};

SettledPart settled_part(const std::vector<SeriesBlock>& blocks, const BlockStretch& stretch,
                         const std::vector<RatioNoise>& noise, double tolerance);

}  // namespace reeve::readings
