// The rows of a file of measured tensions, of readings or of samples: where they begin, what their
// cells say, and what is wrong with one by its file, line, column and value.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/grasp.hpp"
#include "core/text.hpp"
#include "readings/columns.hpp"
#include "readings/wall_clock.hpp"

namespace reeve::readings {

// The row below the header is one of units, or the first reading.
struct Beginning {
  std::optional<CsvRow> units;
  std::optional<CsvRow> first;
  bool is_broken = false;  // neither it nor what follows can be read
};

// Throws InputError if the row is the header, below a line of other names such as a logger's
// channels.
Beginning read_beginning(CsvReader& csv, const ReadingOptions& options, FaultList& faults);

// Reads from the first row up to the end, or to where the file breaks off, which is a fault.
void each_row(CsvReader& csv, const Beginning& beginning, FaultList& faults,
              const std::function<void(const CsvRow&)>& read);

// Throws InputError if there are no readings or samples, and says whether there are zeros.
void require_rows(const CsvReader& csv, std::size_t rows, const std::vector<DataNote>& notes);

// Both read cells that are words, and throw InputError that says what was expected; the place is
// the caller's to name. A grasp is "1;2", "1,2" or "none", of a routing of so many fingers; an
// empty cell has no direction.
Grasp read_held(std::string_view text, int fingers);
std::optional<Direction> read_direction(std::string_view text);
// Notes how these texts are read, but for "pull" and "release". Throws InputError of others.
void note_directions(const std::set<std::string, std::less<>>& words, std::vector<DataNote>& notes);
// True of an empty cell of held fingers, which does not say "none".
bool leaves_held_open(std::string_view text);
// "the held finger is not given in 48 of 48 rows: none is assumed to be held"
std::string held_is_assumed(std::size_t assumed, std::size_t all, std::string_view rows);

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
  const std::vector<std::size_t>& lines() const { return lines_; }

 private:
  bool open_ = false;
  std::vector<double> zeros_;
  std::vector<double> sums_;
  std::vector<double> counts_;
  std::vector<std::size_t> lines_;
};

// True if a run or a routing of this name marks a row of zeros.
bool says_tare(std::string_view name);
// True if a run of this name is a summary of the rows above it: mean, SD, total.
bool says_summary(std::string_view name);

// Numbers of a column in which points may part thousands: 24.665 beside 833.
struct PointCount {
  std::size_t of_three = 0;  // line of the first number with three digits behind its point
  std::size_t whole = 0;     // line of the first from 1 to 999 without a point
  bool has_others = false;   // numbers in which the point is a decimal one

  void add(std::string_view text, std::size_t line);
};

class RowCells {
 public:
  using Numbers = std::vector<std::optional<double>>;

  // All must outlive it.
  RowCells(const CsvReader& csv, const std::vector<DataColumn>& columns, FaultList& faults)
      : csv_(csv),
        columns_(columns),
        faults_(faults),
        numbers_(csv.separator()),
        covariates_(columns.size(), numbers_),
        tare_(columns.size()),
        points_(columns.size()) {}

  // Returns the numbers of a row in reeve's units, by column, without the zeros of the sensors;
  // those of covariates apart. Nothing of a row of zeros, or of another length.
  std::optional<Numbers> numbers(const CsvRow& row);
  // Throws InputError: a column that no one knows may hold words. Dates and versions in it say
  // nothing of the other columns' decimal mark.
  std::optional<double> covariate(const CsvRow& row, std::size_t column);
  // Adds a fault if the covariate's numbers have another decimal mark than the other columns.
  void require_mark(std::size_t covariate, FaultList& faults) const;

  // Runs `action` on the cell. Its input error goes into the list of faults, and it gives nothing.
  template <typename Action>
  auto at(const CsvRow& row, std::size_t column, Action action)
      -> std::optional<decltype(action(std::string_view{}))> {
    try {
      return action(trimmed(row.fields[column]));
    } catch (const InputError& error) {
      add_fault(row, column, error, faults_);
      return std::nullopt;
    }
  }
  void add_fault(const CsvRow& row, std::size_t column, const InputError& error,
                 FaultList& faults) const;

  // Add notes, if there is something to note, on cells and rows that are not read, and on zeros.
  void note_cells(std::vector<DataNote>& notes) const;
  void note_zeros(std::vector<DataNote>& notes) const;
  const std::vector<std::size_t>& lines_of_zeros() const { return tare_.lines(); }

 private:
  bool is_tare(const CsvRow& row) const;
  bool is_summary(const CsvRow& row) const;
  std::optional<double> number(const CsvRow& row, std::size_t column);
  double time(std::string_view text, std::size_t line, std::size_t column);
  static double read_number(std::string_view text, std::size_t line, const DataColumn& column,
                            CsvNumberReader& numbers);

  const CsvReader& csv_;
  const std::vector<DataColumn>& columns_;
  FaultList& faults_;
  CsvNumberReader numbers_;                  // of all columns but covariates
  std::vector<CsvNumberReader> covariates_;  // [column]
  WallClock clock_;
  Tare tare_;
  std::vector<std::size_t> lines_without_name_;
  std::vector<std::size_t> lines_of_summary_;
  std::vector<std::pair<std::string, std::size_t>> errors_;  // words in place of numbers, lines
  std::vector<PointCount> points_;                           // [column]
};

}  // namespace reeve::readings
