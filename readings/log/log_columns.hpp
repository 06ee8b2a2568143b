// What the header of a logger's file says: which column holds what.
//
//   time_s, time_ms, t, timestamp, …   the clock, required
//   position_mm, speed_mm_s            how the carriage moves
//   motor_tension_N, T1_N, Ta_N, …     tensions, as in a file of readings (data_columns.hpp)
//   run, routing, held, direction      labels: text that stays for a while
//   anything else                      a covariate: numbers, which are averaged, or further labels,
//                                      by the first cell that is not empty
//
// Spellings and units are those of every file (intake/column_name.hpp).
#pragma once

#include <optional>
#include <string_view>

#include "numerics/floors.hpp"
#include "readings/column_name.hpp"
#include "readings/columns.hpp"

namespace reeve::readings {

// Names of columns that are not read as the position or the speed of the carriage, and may be one.

// It has the word: "position_rev", "Carriage speed".
bool says_motion(std::string_view name);
// "x_mm", "Weg [mm]".
bool has_unit_of_motion(std::string_view name);

// Names of columns that are not read as a tension, and would be one in another unit.

// Which one: "T3 [V]", "Motor Tension (Nm)". Nothing of a name whose unit tells another quantity,
// such as the temperature "T3 [°C]".
std::optional<ColumnName> tension_in_no_unit_of_force(std::string_view name);

// In seconds per unit; nothing if it is no name of a clock.
std::optional<double> clock_unit(std::string_view column);

// `units` is the row of units, if there is one. What is wrong goes to `faults`; its columns have no
// name.
DataColumns read_log_columns(const CsvReader& csv, const std::optional<CsvRow>& units,
                             const ReadingOptions& options, FaultList& faults);

}  // namespace reeve::readings
