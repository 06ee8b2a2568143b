// Header of a file of measured tensions: role and unit of each column.
//
//   run, routing                 required
//   held, direction              the grasp and which way the carriage moves
//   motor_tension_N, speed_mm_s, cycle, temperature_C, sheath_angle_rad
//   T1_N, T2_N, …                tensions of strands; Ta_N, Tb_N, … of motor-side segments;
//                                Th1_N, … of stretches at the hand; at_T1_N, … of the motor-side
//                                segment at that strand; at least one is required
//   readings, T1_sd_N, …         number of samples of which a row is the mean, their deviation
//   anything else                a covariate, which the model does not know
//
// Other spellings and units are read too (column_name.hpp); what was made of them is noted.
#pragma once

#include "readings/columns.hpp"

namespace reeve::readings {

// `units` is the row of units, if there is one. What is wrong goes to `faults`; its columns have no
// name.
DataColumns read_columns(const CsvReader& csv, const std::optional<CsvRow>& units,
                         const ReadingOptions& options, FaultList& faults);

// True if the noise is that of this column.
bool is_noise_of(const ColumnNoise& given, const DataColumn& column);

}  // namespace reeve::readings
