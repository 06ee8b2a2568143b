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

#include <string>
#include <vector>

#include "readings/columns.hpp"
#include "readings/guessed_column.hpp"

namespace reeve::readings {

// `units` is the row of units, if there is one. What is wrong goes to `faults`; its columns have no
// name.
DataColumns read_columns(const CsvReader& csv, const std::optional<CsvRow>& units,
                         const ReadingOptions& options, FaultList& faults);

// True if the user gives the column's meaning.
bool is_said(const std::string& column, const ReadingOptions& options);
// Guesses the meanings of the covariates of which the user has said nothing; parallel to the
// columns.
std::vector<GuessedColumn> guess_covariates(const Header& header,
                                            const std::optional<CsvRow>& units,
                                            const ReadingOptions& options);
// Asks for the meanings of columns that may be the only ones of such a role.
void require_said(Header& header, const CsvReader& csv, std::vector<GuessedColumn> guesses,
                  const ReadingOptions& options, bool (*is_asked)(DataRole));
// Refuses a tension in a unit that is no force.
void fail_no_force(Header& header, std::size_t column, const std::string& unit,
                   const ReadingOptions& options);

// True if the noise is that of this column.
bool is_noise_of(const ColumnNoise& given, const DataColumn& column);

}  // namespace reeve::readings
