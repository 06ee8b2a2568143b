#include "readings/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

constexpr const char* summary_text =
    "rows named as a summary, such as mean or sd, are left out: if they are readings, give their run "
    "another name";

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
  const bool summary = std::ranges::find(notes, summary_text, &DataNote::text) != notes.end();
  throw InputError({.where = fmt::format("{}:{}", csv.name(), csv.header().line),
                    .expected = zeros ? "readings below the header, and there are rows of zeros "
                                        "(tare) alone"
                                : summary
                                    ? "readings below the header, and there are rows of summary "
                                      "alone: give their runs other names"
                                    : "rows below the header, and there are none"});
}

Grasp read_held(std::string_view text, int fingers) {
  std::string held = lower(without_brackets(text));
  // A number of a spreadsheet or of pandas.
  if (held.size() > 2 && held.ends_with(".0")) held.resize(held.size() - 2);
  std::replace(held.begin(), held.end(), ';', ',');
  held.erase(std::remove(held.begin(), held.end(), ' '), held.end());
  if (is_missing(held) || held == "none") return {};
  if (fingers == 0) throw InputError({.expected = "nothing: the routing has no fingers"});
  // grasp_named reads the form of core: "1,2".
  if (const auto grasp = grasp_named(held, fingers)) return *grasp;
  throw InputError(
      {.expected = fmt::format("{}, or finger numbers from 1 to {}, each once, such as {}",
                               held == "0" ? "none (no finger held)" : "nothing (none held)",
                               fingers, fingers > 1 ? "1;2" : "1")});
}

bool leaves_held_open(std::string_view text) { return is_missing(text); }

std::string held_is_assumed(std::size_t assumed, std::size_t all, std::string_view rows) {
  return fmt::format("the held finger is not given in {} of {} {}: none is assumed to be held",
                     assumed, all, rows);
}

std::optional<Direction> read_direction(std::string_view text) {
  constexpr std::array pulls{"pull",  "pulling", "flexion", "flex",   "flexing",
                             "close", "closing", "load",    "loading"};
  constexpr std::array releases{"release", "releasing", "extension", "extend",   "extending",
                                "open",    "opening",   "unload",    "unloading"};
  const std::string direction = lower(text);
  if (is_missing(direction)) return std::nullopt;
  if (std::ranges::find(pulls, direction) != pulls.end()) return Direction::pull;
  if (std::ranges::find(releases, direction) != releases.end()) return Direction::release;
  throw InputError({.expected = "pull, release, or an empty cell"});
}

void note_directions(const std::set<std::string, std::less<>>& words,
                     std::vector<DataNote>& notes) {
  std::string told;
  for (const std::string& word : words) {
    const auto direction = read_direction(word);
    const std::string_view name = direction == Direction::pull ? "pull" : "release";
    if (!direction || lower(word) == name) continue;
    told += fmt::format("{}'{}' as {}", told.empty() ? "" : ", ", word, name);
  }
  if (told.empty()) return;
  notes.push_back({NoteKind::column_names, "directions are read so: " + told});
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
  if (is_summary(row)) {
    lines_of_summary_.push_back(row.line);
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

bool says_summary(std::string_view name) {
  constexpr std::array words{"mean",
                             "average",
                             "avg",
                             "median",
                             "sd",
                             "std",
                             "stdev",
                             "std dev",
                             "stddev",
                             "min",
                             "max",
                             "minimum",
                             "maximum",
                             "sum",
                             "total",
                             "mittel",
                             "summe",
                             "mittelwert",
                             "stabw",
                             "gesamt",
                             "standard deviation",
                             "standardabweichung"};
  const std::string text = lower(trimmed(name));
  return std::ranges::find(words, text.substr(0, text.find(':'))) != words.end();
}

void PointCount::add(std::string_view text, std::size_t line) {
  if (text.starts_with('-')) text.remove_prefix(1);
  const std::size_t before = std::min(text.find('.'), text.size());
  const bool is_whole = before == text.size() && before <= 3;
  const bool is_of_three = before + 4 == text.size() && before <= 3 && !text.starts_with('0');
  if (is_whole && text != "0" && whole == 0) whole = line;
  if (is_of_three && of_three == 0) of_three = line;
  has_others |= !is_whole && !is_of_three;
}

// A table without a name for its rows, such as pandas writes, has the word in such a column.
bool RowCells::is_summary(const CsvRow& row) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const DataRole role = columns_[i].role;
    const bool is_label =
        !is_of_numbers(role) && role != DataRole::covariate && role != DataRole::group;
    if (is_label && says_summary(row.fields[i])) return true;
  }
  return false;
}

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
              if (is_no_number(text)) {
                if (marks_an_error(text)) errors_.emplace_back(text, row.line);
                return std::nullopt;
              }
              if (columns_[column].role == DataRole::time) return time(text, row.line, column);
              const double value = read_number(text, row.line, columns_[column], numbers_);
              if (!is_of_sensor(columns_[column].role)) return value;
              require_measurable(value);
              if (csv_.separator() != ',') points_[column].add(text, row.line);
              return value;
            })
      .value_or(std::nullopt);
}

double RowCells::time(std::string_view text, std::size_t line, std::size_t column) {
  if (const auto seconds = clock_.read(text)) return *seconds;
  try {
    return read_number(text, line, columns_[column], numbers_);
  } catch (const InputError&) {
    throw InputError(
        {.expected = "the time of the sample: a number, or a time of day with seconds, such as "
                     "9:59:58.25 or 2026-11-30 09:59:58.25"});
  }
}

std::optional<double> RowCells::covariate(const CsvRow& row, std::size_t column) {
  const std::string_view text = trimmed(row.fields[column]);
  if (marks_an_error(text)) errors_.emplace_back(text, row.line);
  if (is_no_number(text)) return std::nullopt;
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

void RowCells::note_cells(std::vector<DataNote>& notes) const {
  try {
    numbers_.require_no_doubt();
    for (const CsvNumberReader& covariate : covariates_) covariate.require_no_doubt();
  } catch (const InputError& error) {
    throw error.at(csv_.name());
  }
  const auto add = [&](NoteKind kind, std::string text, const std::vector<std::size_t>& lines) {
    if (!lines.empty()) notes.push_back({kind, std::move(text), lines});
  };
  add(NoteKind::passed_over, "cells in columns without a name are not read", lines_without_name_);
  add(NoteKind::passed_over, summary_text, lines_of_summary_);
  std::vector<std::size_t> lines_of_errors;
  for (const auto& [word, line] : errors_) lines_of_errors.push_back(line);
  add(NoteKind::passed_over,
      fmt::format(
          "an error or a word in place of a number is read as an empty cell: {} cell{}, '{}' "
          "first",
          errors_.size(), errors_.size() == 1 ? "" : "s",
          errors_.empty() ? "" : for_message(errors_.front().first)),
      lines_of_errors);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const PointCount& points = points_[i];
    if (points.of_three == 0 || points.whole == 0 || points.has_others) continue;
    notes.push_back(
        {NoteKind::units,
         fmt::format("column '{}' has numbers with three digits behind a point beside "
                     "whole numbers: are these thousands separators? They are read as "
                     "decimal points",
                     for_message(columns_[i].name)),
         {std::min(points.of_three, points.whole), std::max(points.of_three, points.whole)}});
  }
}

void RowCells::note_zeros(std::vector<DataNote>& notes) const {
  if (tare_.lines().empty()) return;
  notes.push_back({NoteKind::tare,
                   "these rows have the zeros of the sensors, which are taken off the readings "
                   "below each of them",
                   tare_.lines()});
}

}  // namespace reeve::readings
