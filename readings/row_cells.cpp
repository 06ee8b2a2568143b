#include "readings/row_cells.hpp"

#include <fmt/format.h>

#include <cmath>

#include "readings/text_cells.hpp"
#include "readings/words.hpp"

namespace reeve::readings {
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

}  // namespace reeve::readings
