// What the header of a file of measured tensions says: which column holds what, in which unit.
//
//   run, routing                 required
//   held, direction              the grasp and which way the carriage moves
//   motor_tension_N, speed_mm_s, cycle, temperature_C, sheath_angle_rad
//   T1_N, T2_N, …                tensions of strands; Ta_N, Tb_N, … of motor-side segments;
//                                Th1_N, … of stretches at the hand; at_T1_N, … of the motor-side
//                                segment at that strand; at least one is required
//   readings, T1_sd_N, …         of how many samples a row is the mean, and their deviation
//   anything else                a covariate, which the model does not know
//
// Other spellings and units are read too (intake/column_name.hpp); what was made of them is noted.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "readings/column_name.hpp"
#include "readings/csv.hpp"
#include "readings/fault_list.hpp"
#include "readings/note.hpp"
#include "readings/reading_options.hpp"

namespace reeve::readings {

struct DataColumn {
  DataRole role = DataRole::covariate;
  std::string name;  // as the file has it
  double low = 0;    // range of its numbers, in reeve's unit; not of text
  double high = 0;
  MeasuredPlace place;       // tensions and their deviations only
  Unit unit;                 // of the file's numbers
  std::string meaning = {};  // its name as docs write it; as the file has it where they do not
  bool unit_is_assumed = false;
};

struct DataColumns {
  std::vector<DataColumn> columns;  // parallel to the fields of a row
  std::vector<DataNote> notes;
};

// `units` is the row of units, if there is one (intake/column_units.hpp). What is wrong goes to
// `faults`; its columns have no name.
DataColumns read_columns(const CsvReader& csv, const std::optional<CsvRow>& units,
                         const ReadingOptions& options, FaultList& faults);

// Whether the noise is that of this column.
bool is_noise_of(const ColumnNoise& given, const DataColumn& column);

std::optional<std::size_t> find_column(const std::vector<DataColumn>& columns, DataRole role);

}  // namespace reeve::readings
