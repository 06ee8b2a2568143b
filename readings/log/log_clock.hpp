// The clock of a log, as it shows the time of each sample.
//
// A clock may be coarser than the samples: several in a row show the same time. As they stand, a
// load that grows along a stretch would jump between them, which passes for noise that does not go
// on from sample to sample: readings would be worth too much (effective_readings.hpp). So the m
// samples of one stamp are spread evenly up to the next one,
//
//   t_k = t + k / m (t' - t)      (k = 0 … m - 1)
//
// or, before a gap, where the clock is set back and at the end, by the usual step of a sample.
// Assumed is that samples are taken evenly.
#pragma once

#include "readings/columns.hpp"
#include "readings/log/logged_series.hpp"

namespace reeve::readings {

// Spreads the times of a coarse clock, where one sample in twenty or more repeats the time of the
// one before. Notes that, and a clock that is likely in another unit:
//   - one whose unit is assumed, and makes steps that are long for the log of a carriage, or dates
//     to come: most loggers whose clock has no unit count milliseconds;
//   - one that makes over 5000 samples a second, which no such log needs: seconds in a column
//     time_ms, or the days that spreadsheets count.
void check_clock(LoggedSeries& series, const DataColumn& clock, const ReadingOptions& options);

}  // namespace reeve::readings
