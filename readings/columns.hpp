// The header of a file of measured tensions, of readings or of samples: what each column is by its
// name (column_name.hpp), its unit and what the user says (reading_options.hpp). Which columns must
// be there is for each kind of file to say (data_columns.hpp, log/log_columns.hpp).
//
// Of units, what the user says goes before what the file says, and all that the file says must
// agree: the name, the row of units below the header, and the meaning that a name is given, which
// may be one of another unit ("Kraft [kgf]" as motor_tension_N), or of none.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "readings/column_name.hpp"
#include "readings/csv.hpp"
#include "readings/fault_list.hpp"
#include "readings/note.hpp"
#include "readings/reading_options.hpp"

namespace reeve::readings {

// Allowed values, in reeve's unit.
struct CellRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

struct DataColumn {
  DataRole role = DataRole::covariate;
  std::string name;     // name in the file
  std::string meaning;  // its name in the docs, or the name in the file if they have none
  CellRange range = {};
  MeasuredPlace place = {};  // tensions and their deviations only
  Unit unit = {};            // unit of the file's numbers
  bool unit_is_assumed = false;
};

using ColumnList = std::vector<DataColumn>;  // parallel to the fields of a row

std::optional<std::size_t> find_column(const ColumnList& columns, DataRole role);

// "a title above the header is not read: 'Rig 3'"
std::string titles_text(const std::vector<CsvComment>& titles);

// True if the text is that column's name, or means the same.
bool means(const std::string& text, const DataColumn& column);

// Returns what the user says that the name means, or the name itself.
const std::string& meaning_of(const std::string& name, const ReadingOptions& options);

// Returns the unit of "Kraft Motor kgf", "v_mm_s", "Kraft/kgf"; a unit alone is a name.
std::optional<Unit> unit_at_the_end(std::string_view name, Dimension dimension);

// True if the row below the header has units in place of readings.
bool is_units_row(const CsvRow& header, const CsvRow& row, const ReadingOptions& options);

struct DataColumns {
  ColumnList columns;
  std::vector<DataNote> notes;
};

// Columns and ranges of one kind of file.
struct FileKind {
  bool (*has)(DataRole);  // columns of other roles are covariates there
  CellRange (*range)(DataRole);
};

class Header {
 public:
  // All must outlive it. `units` is the row of units, if there is one. What is wrong goes to
  // `faults`; its columns have no name.
  Header(const CsvReader& csv, const std::optional<CsvRow>& units, const ReadingOptions& options,
         const FileKind& kind, FaultList& faults);

  const ColumnList& columns() const { return columns_; }
  bool has(DataRole role) const { return find_column(columns_, role).has_value(); }
  // Some column cannot be read: it may be one that is missed.
  bool has_bad_column() const { return has_bad_column_; }

  // Adds a fault at the header's line, if it has no place of its own.
  void fail(InputFault fault);
  void fail_column(std::size_t column, std::string expected);
  // Refuses all but one of `given` values of a kind, such as units, for this column.
  void require_one(std::size_t column, std::ptrdiff_t given, const std::string& kind);
  // Adds a note that the column is a covariate.
  void note_covariate(std::string text);
  void set_role(std::size_t column, DataRole role) { columns_[column].role = role; }
  // Makes the column what it would be with an unknown name.
  void make_covariate(std::size_t column);
  // Notes that the clock has times of day, which need no unit (wall_clock.hpp).
  void take_times_of_day(std::size_t clock);

  // Returns the columns, with notes on how names and units were taken.
  DataColumns finish();

 private:
  void add_column(std::size_t index);
  DataColumn read(const std::string& name, std::size_t index);
  bool has_other_meaning(const std::string& name, std::size_t index);
  std::optional<std::size_t> same_as(const DataColumn& column) const;
  void fail_same(std::size_t index, std::size_t first);
  void require_each_once();
  void require_options();
  std::string nearest_column(const std::string& name) const;
  void note_titles();
  std::string told(const DataColumn& column, const ColumnName& named,
                   const std::optional<Unit>& in_name) const;

  const CsvReader& csv_;
  const std::optional<CsvRow>& units_;
  const ReadingOptions& options_;
  const FileKind& kind_;
  FaultList& faults_;
  std::optional<std::string> group_;  // the header of the column of groups
  std::vector<DataColumn> columns_;
  std::vector<std::string> read_as_;  // "'T1 [lbf]' as T1_N"; "" where there is nothing to say
  std::vector<DataNote> notes_;
  bool has_bad_column_ = false;
};

}  // namespace reeve::readings
