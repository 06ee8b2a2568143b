#include "readings/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace reeve::readings {
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

// Adds one fault, however many headers there are, in files that were put together as they stand.
void add_repeated_headers(const CsvReader& csv, const std::vector<std::size_t>& lines,
                          FaultList& faults) {
  if (lines.empty()) return;
  std::string what = fmt::format("line {} repeats the header", lines.front());
  if (lines.size() > 1) what += fmt::format(", and so do {} more", lines.size() - 1);
  faults.add(lines.front(), "where the header is repeated",
             {.where = fmt::format("{}:{}", csv.name(), lines.front()),
              .what = what,
              .expected = "one header at the beginning: where files were put together, take out "
                          "that of each but the first, and see that runs of different files "
                          "have names of their own"});
}

// A spreadsheet's rounding of 0 (some 1e-16) may stay; the square of far less is no number.
void require_measurable(double tension_N) {
  constexpr double least_N = 1e-30;
  if (tension_N == 0 || std::abs(tension_N) >= least_N) return;
  throw InputError({.expected = fmt::format("0, or a tension of at least {} N", least_N)});
}

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
  std::vector<std::size_t> headers;  // lines
  const auto take = [&](const CsvRow& row) {
    if (row.fields != csv.header().fields) return read(row);
    headers.push_back(row.line);
  };
  CsvRow row;
  if (beginning.first) take(*beginning.first);
  try {
    while (csv.next(row)) take(row);
  } catch (const InputError& error) {
    faults.add(row.line + 1, "where the rest cannot be read", error.fault());
  }
  add_repeated_headers(csv, headers, faults);
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

Grasp read_held(std::string_view text, int fingers) {
  std::string held = lower(text);
  std::replace(held.begin(), held.end(), ';', ',');
  held.erase(std::remove(held.begin(), held.end(), ' '), held.end());
  if (is_missing(held) || held == "none") return {};
  if (fingers == 0) throw InputError({.expected = "nothing: the routing has no fingers"});
  // grasp_named reads the form of core: "1,2".
  if (const auto grasp = grasp_named(held, fingers)) return *grasp;
  throw InputError(
      {.expected = fmt::format("nothing (none held), or finger numbers from 1 to {}, each "
                               "once, such as {}",
                               fingers, fingers > 1 ? "1;2" : "1")});
}

bool leaves_held_open(std::string_view text) { return is_missing(text) && lower(text) != "none"; }

std::string held_is_assumed(std::size_t assumed, std::size_t all, std::string_view rows) {
  return fmt::format("the held finger is not given in {} of {} {}: none is assumed to be held",
                     assumed, all, rows);
}

std::optional<Direction> read_direction(std::string_view text) {
  const std::string direction = lower(text);
  if (is_missing(direction)) return std::nullopt;
  if (direction == "pull") return Direction::pull;
  if (direction == "release") return Direction::release;
  throw InputError({.expected = "pull, release, or an empty cell"});
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

std::optional<RowCells::Numbers> RowCells::numbers(const CsvRow& row) {
  if (row.ragged) {
    faults_.add(row.line, "rows of another length", *row.ragged);
    return std::nullopt;
  }
  Numbers result(columns_.size());
  bool has_cell_without_name = false;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (is_of_numbers(columns_[i].role)) result[i] = number(row, i);
    has_cell_without_name |=
        columns_[i].role == DataRole::no_name && !trimmed(row.fields[i]).empty();
  }
  if (has_cell_without_name) lines_without_name_.push_back(row.line);
  if (is_tare(row)) {
    tare_.add(row.line, result);
    return std::nullopt;
  }
  tare_.close();
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (result[i] && is_of_sensor(columns_[i].role)) *result[i] -= tare_.zero(i);
  }
  return result;
}

bool says_tare(std::string_view name) { return lower(trimmed(name)) == "tare"; }

bool RowCells::is_tare(const CsvRow& row) const {
  const auto cell_says_tare = [&](DataRole role) {
    const auto column = find_column(columns_, role);
    return column && says_tare(row.fields[*column]);
  };
  return cell_says_tare(DataRole::run) || cell_says_tare(DataRole::routing);
}

std::optional<double> RowCells::number(const CsvRow& row, std::size_t column) {
  return at(row, column,
            [&](std::string_view text) -> std::optional<double> {
              if (is_missing(text)) return std::nullopt;
              const double value = read_number(text, row.line, columns_[column], numbers_);
              if (is_of_sensor(columns_[column].role)) require_measurable(value);
              return value;
            })
      .value_or(std::nullopt);
}

std::optional<double> RowCells::covariate(const CsvRow& row, std::size_t column) {
  const std::string_view text = trimmed(row.fields[column]);
  if (is_missing(text)) return std::nullopt;
  return read_number(text, row.line, columns_[column], covariates_[column]);
}

double RowCells::read_number(std::string_view text, std::size_t line, const DataColumn& column,
                             CsvNumberReader& numbers) {
  const Unit& unit = column.unit;
  const bool may_be_empty = column.role != DataRole::time;
  return unit.converted(numbers.read(text, line, unit.back(column.range.low),
                                     unit.back(column.range.high), may_be_empty));
}

void RowCells::require_mark(std::size_t covariate, FaultList& faults) const {
  try {
    covariates_[covariate].require_mark_of(numbers_);
  } catch (const InputError& error) {
    const std::string& name = columns_[covariate].name;
    const std::string place = fmt::format("{}: column '{}'", csv_.name(), for_message(name));
    faults.add(0, in_column(name), error.at(place).fault());
  }
}

void RowCells::add_fault(const CsvRow& row, std::size_t column, const InputError& error,
                         FaultList& faults) const {
  const std::string& name = columns_[column].name;
  const std::string_view text = trimmed(row.fields[column]);
  faults.add(row.line, in_column(name),
             cell_error(error, csv_.name(), row.line, name, text).fault());
}

void RowCells::note_cells_without_name(std::vector<DataNote>& notes) const {
  if (lines_without_name_.empty()) return;
  notes.push_back(
      {NoteKind::passed_over, "cells in columns without a name are not read", lines_without_name_});
}

void RowCells::note_zeros(std::vector<DataNote>& notes) const {
  if (tare_.lines().empty()) return;
  notes.push_back({NoteKind::tare,
                   "these rows have the zeros of the sensors, which are taken off the readings "
                   "below each of them",
                   tare_.lines()});
}

}  // namespace reeve::readings
