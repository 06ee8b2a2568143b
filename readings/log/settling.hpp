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
// tension (ratio_noise.hpp), and more of it the farther the forecast. Two blocks off the line in a
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

#include "readings/log/ratio_noise.hpp"
#include "readings/log/recordings.hpp"

namespace reeve::readings {

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
