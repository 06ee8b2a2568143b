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
#include <string_view>

#include "numerics/floors.hpp"
#include "readings/columns.hpp"
#include "readings/log/logged_series.hpp"

namespace reeve::readings {

// Text of a clock on the wall, which is no number of seconds.

// "12:00:00.01", "2024-05-01T12:00:00Z"
bool is_time_of_day(std::string_view text);
// One of these, a date alone ("2024-05-01", "1.5.2024", "5/1/24"), or whatever else a colon parts
// numbers in.
bool is_date_or_time(std::string_view text);

// Nothing where fewer than one sample in twenty repeats the time of the one before.
std::optional<DataNote> spread_repeated_times(LoggedSeries& series);

// A clock that is too fast for the log of a carriage: over 5000 samples a second, which no such log
// needs. Mostly its unit is another one: seconds in a column time_ms, or the days that spreadsheets
// count.

std::optional<DataNote> doubt_of_fast_clock(const LoggedSeries& series, const DataColumn& clock,
                                            const ReadingOptions& options);

}  // namespace reeve::readings
