// A clock that is too fast for the log of a carriage: over 5000 samples a second, which no such log
// needs. Mostly its unit is another one: seconds in a column time_ms, or the days that spreadsheets
// count.
#pragma once

#include <optional>

#include "readings/data_columns.hpp"
#include "readings/log/logged_series.hpp"

namespace reeve::readings {

std::optional<DataNote> doubt_of_fast_clock(const LoggedSeries& series, const DataColumn& clock,
                                            const ReadingOptions& options);

}  // namespace reeve::readings
