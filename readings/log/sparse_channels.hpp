// Tensions that readings do not have, since the log has them too seldom: a mean is made of a
// channel that at least half of a reading's samples have (steady_reading.hpp). A channel that has
// no value there at all is off, and no matter of this.
#pragma once

#include <vector>

#include "readings/log/steady_reading.hpp"
#include "readings/note.hpp"

namespace reeve::readings {

// One note for each such channel, with the share that is missing.
std::vector<DataNote> sparse_channels(const LoggedSeries& series,
                                      const std::vector<SteadyReading>& readings);

}  // namespace reeve::readings
