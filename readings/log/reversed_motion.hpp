// Whether a log's position or speed counts the other way: friction adds to the motor tension while
// the carriage pulls, and takes from it while it releases.
//
// That is said where the median motor tension of pulling readings is below that of releasing ones
// by more than the tolerance and three standard errors of the two medians, loads that differ
// included. A controller that holds the motor tension makes it say nothing. (Nor is a single strand
// as good a witness: where a finger is held, one may carry less while the carriage releases.)
#pragma once

#include <optional>
#include <vector>

#include "readings/log/steady_reading.hpp"
#include "readings/note.hpp"

namespace reeve::readings {

std::optional<DataNote> reversed_motion(const std::vector<SteadyReading>& readings,
                                        double tolerance);

}  // namespace reeve::readings
