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
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "readings/column_name.hpp"
#include "readings/csv.hpp"
#include "readings/fault_list.hpp"
#include "readings/note.hpp"
#include "readings/reading_options.hpp"

namespace reeve::readings {

// What is wrong with a file's header, in the list of the file's faults.

class HeaderFaults {
 public:
  // Both must outlive it.
  HeaderFaults(const CsvReader& csv, FaultList& faults) : csv_(csv), faults_(faults) {}

  // At the header's line, if the fault has no place of its own.
  void add(InputFault fault);
  void add_column(std::size_t column, std::string expected);

 private:
  const CsvReader& csv_;
  FaultList& faults_;
};

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

// The header of a file of measured tensions, name by name: what each column is by its name
// (column_name.hpp), its unit (column_units.hpp) and what the user says (reading_options.hpp). What
// must be there is for each kind of file to say.

struct CellRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

// What files of one kind have.
struct FileKind {
  bool (*has)(DataRole);         // columns of other roles are covariates there
  CellRange (*range)(DataRole);  // in reeve's unit
};

struct HeaderColumns {
  std::vector<DataColumn> columns;  // parallel to the fields of a row
  std::vector<std::string>
      read_as;  // likewise: "'T1 [lbf]' as T1_N"; "" where there is nothing to say
  std::vector<DataNote> notes;
  bool has_bad_column = false;
};

// What is wrong goes to `faults`; its columns have no name.
HeaderColumns read_header(const CsvReader& csv, const std::optional<CsvRow>& units,
                          const ReadingOptions& options, const FileKind& kind,
                          HeaderFaults& faults);

// As if nobody knew its name.
void make_covariate(HeaderColumns& header, std::size_t column);

// How names and units were taken, and what else there is to note.
std::vector<DataNote> header_notes(const HeaderColumns& header, const std::optional<CsvRow>& units);

// Which unit a column's numbers are in: what the user says goes before what the file says, and all
// that the file says must agree: the name, the row of units, and the meaning that a name is given,
// which may be one of another unit ("Kraft [kgf]" as motor_tension_N), or of none.

// What the name means where the user has said so, or else the name itself.
const std::string& meaning_of(const std::string& name, const ReadingOptions& options);

// The row below the header if it has units in place of readings.
bool is_units_row(const CsvRow& header, const CsvRow& row, const ReadingOptions& options);

// Whether the text is that column's name, or means the same.
bool means(const std::string& text, const std::string& name, DataRole role,
           const MeasuredPlace& place);

// What the column's name says, or else the meaning that it is given.
std::optional<Unit> unit_of_name(const ColumnName& named, const std::string& name,
                                 const ReadingOptions& options);

// Nothing where nobody says it. Throws InputError that says what was expected.
std::optional<Unit> unit_of(const ColumnName& named, const std::string& name,
                            const std::optional<CsvRow>& units, std::size_t index,
                            const ReadingOptions& options);

}  // namespace reeve::readings
