// Datasets from the text of a CSV file.
#pragma once

#include <numeric>
#include <string>
#include <vector>

#include "diagnosis/dataset.hpp"
#include "diagnosis/verdict/compared_cell.hpp"
#include "tests/readings/read_data.hpp"

namespace reeve::testing {

inline std::vector<std::size_t> all_readings(const MeasuredData& data) {
  std::vector<std::size_t> readings(data.readings.size());
  std::iota(readings.begin(), readings.end(), std::size_t{0});
  return readings;
}

inline Dataset all_of(const MeasuredData& data) { return dataset(data, all_readings(data)); }

// Every tension beside forecasts that are just so.
inline std::vector<ComparedCell> cells_as_measured(const MeasuredData& data) {
  std::vector<ComparedCell> cells;
  for (const Cell& cell : all_of(data).cells) {
    ComparedCell compared;
    compared.cell = cell;
    compared.before_N = compared.after_N = cell.measured_N;
    cells.push_back(compared);
  }
  return cells;
}

}  // namespace reeve::testing
