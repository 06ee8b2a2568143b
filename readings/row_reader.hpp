// Rows of a file of measured tensions, one after the other, into readings. What is wrong with a row
// goes into the list of faults, all of it, and the row into nothing else.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "readings/covariates.hpp"
#include "readings/data_columns.hpp"
#include "readings/measured_data.hpp"
#include "readings/routing_table.hpp"
#include "readings/row_cells.hpp"
#include "readings/tare.hpp"

namespace reeve::readings {

class RowReader {
 public:
  // All must outlive the reader.
  RowReader(const CsvReader& csv, const std::vector<DataColumn>& columns,
            const RoutingResolver& resolve, const ReadingOptions& options, FaultList& faults);

  void read(const CsvRow& row);
  // Once all rows are read.
  MeasuredData finish();

 private:
  std::optional<std::size_t> run(const CsvRow& row);
  std::optional<std::size_t> group(const CsvRow& row);
  std::optional<std::size_t> routing(const CsvRow& row);
  void read_words(const CsvRow& row, Reading& reading);
  void set_numbers(const CsvRow& row, const RowCells::Numbers& numbers, Reading& reading);
  void read_covariates(const CsvRow& row, Reading& reading);
  void set_conditions(const RowCells::Numbers& numbers, Reading& reading) const;
  void set_tension(const CsvRow& row, std::size_t column, double tension_N, Reading& reading);
  void set_errors(const RowCells::Numbers& numbers, Reading& reading) const;
  void require_tension(const CsvRow& row, const RowCells::Numbers& numbers);
  void note_what_is_passed_over();
  void set_known_noise();

  const CsvReader& csv_;
  const std::vector<DataColumn>& columns_;
  const ReadingOptions& options_;
  FaultList& faults_;
  RowCells cells_;
  RoutingTable routings_;
  Covariates covariates_;
  Tare tare_;
  std::map<std::string, std::size_t, std::less<>> runs_;
  std::map<std::string, std::size_t, std::less<>> groups_;
  MeasuredData data_;
};

}  // namespace reeve::readings
