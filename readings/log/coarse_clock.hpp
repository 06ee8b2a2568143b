// A clock that is coarser than the samples: several in a row show the same time. As they stand, a
// load that grows along a stretch would jump between them, which passes for noise that does not go
// on from sample to sample: readings would be worth too much (effective_readings.hpp). So the m
// samples of one stamp are spread evenly up to the next one,
//
//   t_k = t + k / m (t' - t)      (k = 0 … m - 1)
//
// or, before a gap, where the clock is set back and at the end, by the usual step of a sample.
// Assumed is that samples are taken evenly.
#pragma once

#include <optional>

#include "readings/log/logged_series.hpp"

namespace reeve::readings {

// Nothing where fewer than one sample in twenty repeats the time of the one before.
std::optional<DataNote> spread_repeated_times(LoggedSeries& series);

}  // namespace reeve::readings
