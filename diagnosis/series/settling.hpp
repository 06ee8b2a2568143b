// From where on all contacts slide, within a stretch in which the carriage moves evenly.
//
// After a turn or a rest the contacts begin to slide one after another. Until then the tensions
// come nearer to their ratios; from then on the ratios to the load, q = T / T_load, go on as they
// went, whether the load stays or grows (T_load: motor tension, or the sum of the tensions). So the
// stretch is walked backwards from its end, as long as every q goes on along the straight line
// through the least time behind, to within
//
//   (tolerance + 4 sd) · median q
//
// with sd the relative deviation of such forecasts over all stretches of the log, and more of it
// the farther the forecast. Two blocks off the line in a row end the walk, and so do the third to
// the fifth together, as where q bends slowly; a single one is passed over. The first block of what
// is left may hold the last contact's start, and is left out too. Idea: the settling time of
// control engineering, about a trend instead of a level.
//
// The stretch is looked at in 50 blocks at most, since a bend is as slow as the carriage. What is
// found must follow the load: from its first to its last third q changes by no more than that much
// and half of ln of what the load grows by; where a contact sticks, T stays and ln q falls by all
// of it.
#pragma once

#include <cstddef>
#include <vector>

#include "diagnosis/series/series_blocks.hpp"
#include "diagnosis/series/stretch_of_blocks.hpp"

namespace reeve::diagnosis {

// Relative standard deviations, one for each tension, of the forecasts that the walk makes.
std::vector<double> ratio_noise(const std::vector<std::vector<SeriesBlock>>& recordings,
                                const std::vector<std::vector<BlockStretch>>& stretches);

// The first settled block of the stretch; its end if none is.
std::size_t settled_from(const std::vector<SeriesBlock>& blocks, const BlockStretch& stretch,
                         const std::vector<double>& noise, double tolerance);

}  // namespace reeve::diagnosis
