#include "readings/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "readings/column_name.hpp"
#include "readings/columns.hpp"
#include "readings/csv.hpp"

namespace reeve::readings {

Grasp read_held(std::string_view text, int fingers) {
  std::string held = lower(text);
  std::replace(held.begin(), held.end(), ';', ',');
  held.erase(std::remove(held.begin(), held.end(), ' '), held.end());
  if (is_missing(held) || held == "none") return {};
  if (fingers == 0) throw InputError({.expected = "nothing: the routing has no fingers"});
  // As core writes it: "1,2".
  if (const auto grasp = grasp_named(held, fingers)) return *grasp;
  throw InputError(
      {.expected = fmt::format("nothing (none held), or finger numbers from 1 to {}, each "
                               "once, such as {}",
                               fingers, fingers > 1 ? "1;2" : "1")});
}

std::optional<Direction> read_direction(std::string_view text) {
  const std::string direction = lower(text);
  if (is_missing(direction)) return std::nullopt;
  if (direction == "pull") return Direction::pull;
  if (direction == "release") return Direction::release;
  throw InputError({.expected = "pull, release, or an empty cell"});
}

bool says_tare(std::string_view text) { return lower(text) == "tare"; }

namespace {

// What a spreadsheet leaves of nothing (some 1e-16) may stay; the square of far less is no number.
void require_measurable(double tension_N) {
  constexpr double least_N = 1e-30;
  if (tension_N == 0 || std::abs(tension_N) >= least_N) return;
  throw InputError({.expected = fmt::format("0, or a tension of at least {} N", least_N)});
}

}  // namespace

std::string in_column(const DataColumn& column) {
  return fmt::format("in column '{}'", for_message(column.name));
}

RowCells::RowCells(const CsvReader& csv, const std::vector<DataColumn>& columns, FaultList& faults)
    : csv_(csv), columns_(columns), faults_(faults), numbers_(csv.separator()) {}

InputFault RowCells::fault(const CsvRow& row, std::size_t column, const InputError& error) const {
  return cell_error(error, csv_.name(), row.line, columns_[column].name,
                    trimmed(row.fields[column]))
      .fault();
}

std::string_view RowCells::cell(const CsvRow& row, DataRole role) const {
  const auto column = find_column(columns_, role);
  return column ? trimmed(row.fields[*column]) : std::string_view();
}

RowCells::Numbers RowCells::numbers(const CsvRow& row) {
  Numbers result(columns_.size());
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if (is_of_numbers(columns_[column].role)) result[column] = number(row, column);
    if (columns_[column].role == DataRole::no_name && !trimmed(row.fields[column]).empty() &&
        (lines_without_name_.empty() || lines_without_name_.back() != row.line)) {
      lines_without_name_.push_back(row.line);
    }
  }
  return result;
}

std::optional<double> RowCells::number(const CsvRow& row, std::size_t column) {
  const DataColumn& of = columns_[column];
  return at(row, column,
            [&](std::string_view text) -> std::optional<double> {
              if (is_missing(text)) return std::nullopt;
              const double value = of.unit.converted(
                  numbers_.read(text, row.line, of.unit.back(of.low), of.unit.back(of.high),
                                of.role != DataRole::time));
              const bool is_tension =
                  of.role == DataRole::tension || of.role == DataRole::motor_tension;
              if (is_tension) require_measurable(value);
              return value;
            })
      .value_or(std::nullopt);
}

std::optional<double> RowCells::covariate(const CsvRow& row, std::size_t column) {
  const std::string_view text = trimmed(row.fields[column]);
  if (is_missing(text)) return std::nullopt;
  const DataColumn& of = columns_[column];
  return of.unit.converted(
      numbers_.read(text, row.line, of.unit.back(of.low), of.unit.back(of.high)));
}

void Tare::add(std::size_t line, const std::vector<std::optional<double>>& zeros) {
  if (!open_) {
    std::fill(sums_.begin(), sums_.end(), 0.0);
    std::fill(counts_.begin(), counts_.end(), 0.0);
  }
  open_ = true;
  lines_.push_back(line);
  for (std::size_t column = 0; column < zeros_.size(); ++column) {
    if (!zeros[column]) continue;
    sums_[column] += *zeros[column];
    counts_[column] += 1;
    zeros_[column] = sums_[column] / counts_[column];
  }
}

std::vector<DataNote> Tare::notes() const {
  if (lines_.empty()) return {};
  return {{NoteKind::tare,
           "these rows have the zeros of the sensors, which are taken off the readings below each "
           "of them",
           lines_}};
}

bool is_tare(const RowCells& cells, const CsvRow& row) {
  return says_tare(cells.cell(row, DataRole::run)) || says_tare(cells.cell(row, DataRole::routing));
}

void take_zeros(const Tare& tare, const std::vector<DataColumn>& columns,
                RowCells::Numbers& numbers) {
  for (std::size_t column = 0; column < columns.size(); ++column) {
    if (numbers[column] && is_of_sensor(columns[column].role)) {
      *numbers[column] -= tare.zero(column);
    }
  }
}

namespace {

std::ptrdiff_t names_known_in(const CsvRow& row, const ReadingOptions& options) {
  return std::count_if(row.fields.begin(), row.fields.end(), [&](std::string_view field) {
    return try_column_named(meaning_of(std::string(trimmed(field)), options)).has_value();
  });
}

// The line below may be the header, and this one a logger's names of its channels.
void require_header_first(const CsvReader& csv, const CsvRow& row, const ReadingOptions& options) {
  const CsvRow& header = csv.header();
  if (names_known_in(header, options) > 0 || names_known_in(row, options) < 2) return;
  throw InputError(
      {.where = fmt::format("{}:{}", csv.name(), header.line),
       .what = fmt::format("no name in this line is one of a column, and line {} has such names",
                           row.line),
       .expected = "the header first: take this line out, or begin it with #"});
}

// Of files that were put together as they stand.
class RepeatedHeaders {
 public:
  void add(std::size_t line) {
    if (count_++ == 0) first_ = line;
  }

  // One fault, however many there are.
  void tell(const CsvReader& csv, FaultList& faults) const {
    if (count_ == 0) return;
    std::string what = fmt::format("line {} repeats the header", first_);
    if (count_ > 1) what += fmt::format(", and so do {} more", count_ - 1);
    faults.add(first_, "where the header is repeated",
               {.where = fmt::format("{}:{}", csv.name(), first_),
                .what = what,
                .expected = "one header at the beginning: where files were put together, take out "
                            "that of each but the first, and see that runs of different files "
                            "have names of their own"});
  }

 private:
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

}  // namespace

Beginning read_beginning(CsvReader& csv, const ReadingOptions& options, FaultList& faults) {
  Beginning result;
  try {
    CsvRow row;
    if (!csv.next(row)) return result;
    (is_units_row(csv.header(), row, options) ? result.units : result.first) = std::move(row);
  } catch (const InputError& error) {
    result.is_broken = true;
    faults.add(csv.header().line + 1, "where the rest cannot be read", error.fault());
  }
  if (result.first) require_header_first(csv, *result.first, options);
  return result;
}

void each_row(CsvReader& csv, const Beginning& beginning, FaultList& faults,
              const std::function<void(const CsvRow&)>& read) {
  if (beginning.is_broken) return;
  RepeatedHeaders repeated;
  const auto take = [&](const CsvRow& row) {
    if (row.fields == csv.header().fields) {
      repeated.add(row.line);
    } else {
      read(row);
    }
  };
  CsvRow row;
  if (beginning.first) take(*beginning.first);
  try {
    while (csv.next(row)) take(row);
  } catch (const InputError& error) {
    faults.add(row.line + 1, "where the rest cannot be read", error.fault());
  }
  repeated.tell(csv, faults);
}

void require_rows(const CsvReader& csv, std::size_t rows, const std::vector<DataNote>& notes) {
  if (rows > 0) return;
  const bool zeros = std::any_of(notes.begin(), notes.end(),
                                 [](const DataNote& note) { return note.kind == NoteKind::tare; });
  throw InputError({.where = fmt::format("{}:{}", csv.name(), csv.header().line),
                    .expected = zeros ? "readings below the header, and there are rows of zeros "
                                        "(tare) alone"
                                      : "rows below the header, and there are none"});
}

}  // namespace reeve::readings
