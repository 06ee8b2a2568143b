// The header of a file of measured tensions, name by name: what each column is by its name
// (column_name.hpp), its unit (column_units.hpp) and what the user says (reading_options.hpp). What
// must be there is for each kind of file to say.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "readings/data_columns.hpp"
#include "readings/header_faults.hpp"

namespace reeve::readings {

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

}  // namespace reeve::readings
