// Begin of sliding at all contacts, within a stretch of even carriage motion.
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
  double tension_N = 0;  // usual tension over the stretch
  double error_N = 0;
};

// Noise of the forecasts of a tension's ratio to the load, q = T / T_load.
//
// A sensor scatters by a fixed number of newton, and its drive by a share of the tension. The
// standard deviation of a forecast of T is therefore
//
//   s² = a² + b² T²
//
// and that of q is s / T_load. A strand that reads far less while the carriage pulls than while it
// releases thus has other relative noise in each. The two parts follow from the third of the
// forecasts with the least tensions and the third with the greatest. If these are hardly apart, all
// noise is a. Below the lower third, s stays as it is there, since there are no data.
struct RatioNoise {
  double least_tension_N = 0;  // least tension with data
  double absolute_N = 0;       // a
  double relative = 0;         // b

  double at(double tension_N) const;  // s
};

RatioNoise ratio_noise(std::vector<ForecastError> errors);

// Returns the noise of the walk's forecasts, one for each tension.
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
