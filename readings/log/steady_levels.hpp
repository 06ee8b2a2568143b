// Steady levels of a log that has neither position nor speed, such as a load test in steps:
// stretches in which the load and every tension stay at their means, to within
//
//   tolerance · load  +  4 sd
//
// and do not go on rising or falling by more than that, sd being the noise of the blocks. The
// first and the last block of each are left out, since a step may lie inside.
//
// A level that lies above the one before was reached by pulling, one below by releasing; the first
// one is compared with how the recording begins. Whether the tendon still slides there, such a log
// does not say.
#pragma once

#include <vector>

#include "readings/log/recordings.hpp"

namespace reeve::readings {

// Standard deviations from second differences, one for each tension, and that of the load.
std::vector<double> block_noise(const std::vector<std::vector<SeriesBlock>>& recordings);

std::vector<BlockStretch> steady_levels(const std::vector<SeriesBlock>& blocks,
                                        const std::vector<double>& noise_N, double tolerance,
                                        double width_s);

}  // namespace reeve::readings
