// Header of a logger's file: role and unit of each column.
//
//   time_s, time_ms, t, timestamp, …   the clock, required
//   position_mm, speed_mm_s            how the carriage moves
//   motor_tension_N, T1_N, Ta_N, …     tensions, as in a file of readings (data_columns.hpp)
//   run, routing, held, direction      labels: text that stays for a while
//   anything else                      a covariate: numbers, which are averaged, or further labels,
//                                      by the first cell that is not empty
//
// Spellings and units are those of every file (column_name.hpp).
#pragma once

#include "readings/columns.hpp"
#include "readings/rows.hpp"

namespace reeve::readings {

// Adds what is wrong to `faults`; its columns have no name.
DataColumns read_log_columns(const CsvReader& csv, const Beginning& beginning,
                             const ReadingOptions& options, FaultList& faults);

}  // namespace reeve::readings
