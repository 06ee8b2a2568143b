// The cells of a file of measured tensions: words and numbers, and what is wrong with one by its
// file, line, column and value.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "readings/csv_number.hpp"
#include "readings/data_columns.hpp"

namespace reeve::readings {

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

}  // namespace reeve::readings
