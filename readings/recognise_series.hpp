// Recognises a logger's time series in a file of readings: rows that a clock has written. Their
// noise goes on from row to row, so thousands of them say no more than some tens of readings.
//
// A file is a time series if
//   - it has a clock (column_name.hpp) and 200 rows or more, and within the runs 97 % of the
//     steps of the clock are within a fifth of their median, and the load goes on from row to row
//     (lag-1 autocorrelation of 0.3 or more); or 100 rows or more, every 0.05 s or faster;
//   - or it has no clock and 1000 rows or more, and of half of its channels or more the share of
//     the load goes on from row to row: lag-1 autocorrelation above 0.7, and that of its
//     differences above -0.3. Independent noise gives -1/2 there whatever lies below it, so that
//     readings in the order of their load are no series.
#pragma once

#include <optional>

#include "readings/measured_data.hpp"

namespace reeve::readings {

std::optional<DataNote> recognise_series(const MeasuredData& data);

}  // namespace reeve::readings
