// The cells of a file of measured tensions: words and numbers, and what is wrong with one by its
// file, line, column and value.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/grasp.hpp"
#include "core/text.hpp"
#include "readings/columns.hpp"
#include "readings/csv.hpp"
#include "readings/fault_list.hpp"
#include "readings/note.hpp"
#include "readings/reading_options.hpp"

namespace reeve::readings {

// The cells of a row that are words. All throw InputError that says what was expected; the place is
// the caller's to name.

// "1;2", "1,2", "none"; of a routing of so many fingers.
Grasp read_held(std::string_view text, int fingers);
// Nothing of an empty cell.
std::optional<Direction> read_direction(std::string_view text);
// A row that has zeros in place of readings.
bool says_tare(std::string_view text);

// "in column 'T1_N'": what faults of one column are counted by.
std::string in_column(const DataColumn& column);

class RowCells {
 public:
  using Numbers = std::vector<std::optional<double>>;

  // All must outlive it.
  RowCells(const CsvReader& csv, const std::vector<DataColumn>& columns, FaultList& faults);

  // Runs `action` on the cell. Its input error goes into the list of faults, and it gives nothing.
  template <typename Action>
  auto at(const CsvRow& row, std::size_t column, Action action)
      -> std::optional<decltype(action(std::string_view{}))> {
    try {
      return action(trimmed(row.fields[column]));
    } catch (const InputError& error) {
      faults_.add(row.line, in_column(columns_[column]), fault(row, column, error));
      return std::nullopt;
    }
  }
  InputFault fault(const CsvRow& row, std::size_t column, const InputError& error) const;

  // Empty where the file has no such column.
  std::string_view cell(const CsvRow& row, DataRole role) const;
  // In reeve's units, by column; those of covariates apart.
  Numbers numbers(const CsvRow& row);
  // Throws InputError: a column that no one knows may hold words.
  std::optional<double> covariate(const CsvRow& row, std::size_t column);

  // That have something in a column without a name, of the rows whose numbers were read.
  const std::vector<std::size_t>& lines_without_name() const { return lines_without_name_; }

 private:
  std::optional<double> number(const CsvRow& row, std::size_t column);

  const CsvReader& csv_;
  const std::vector<DataColumn>& columns_;
  FaultList& faults_;
  CsvNumberReader numbers_;
  std::vector<std::size_t> lines_without_name_;
};

// Zeros of the sensors: a row whose run or routing is called tare has what each sensor reads
// without load. It is taken off the readings below, until the next such row:
//
//   T = reading − zero
//
// Rows of zeros that follow one another are averaged. A cell that is empty keeps the zero from
// before.

class Tare {
 public:
  explicit Tare(std::size_t columns) : zeros_(columns), sums_(columns), counts_(columns) {}

  // `zeros` by column, of a row of zeros.
  void add(std::size_t line, const std::vector<std::optional<double>>& zeros);
  // A row of readings has come: the next zeros replace these.
  void close() { open_ = false; }

  double zero(std::size_t column) const { return zeros_[column]; }
  // Empty if there were no zeros.
  std::vector<DataNote> notes() const;

 private:
  bool open_ = false;
  std::vector<double> zeros_;
  std::vector<double> sums_;
  std::vector<double> counts_;
  std::vector<std::size_t> lines_;
};

// Whether its run or its routing says so.
bool is_tare(const RowCells& cells, const CsvRow& row);
// Off each sensor.
void take_zeros(const Tare& tare, const std::vector<DataColumn>& columns,
                RowCells::Numbers& numbers);

// Where the rows of a file begin: the row below the header is one of units, or the first reading.
// Throws InputError if it is the header, below a line of other names such as a logger's channels.

struct Beginning {
  std::optional<CsvRow> units;
  std::optional<CsvRow> first;
  bool is_broken = false;  // neither it nor what follows can be read
};

Beginning read_beginning(CsvReader& csv, const ReadingOptions& options, FaultList& faults);

// From the first one up to the end, or to where the file breaks off, which is a fault.
void each_row(CsvReader& csv, const Beginning& beginning, FaultList& faults,
              const std::function<void(const CsvRow&)>& read);

// Of samples or readings. Throws InputError if there are none, and says whether there are zeros.
void require_rows(const CsvReader& csv, std::size_t rows, const std::vector<DataNote>& notes);

}  // namespace reeve::readings
