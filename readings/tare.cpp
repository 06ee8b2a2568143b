#include "readings/tare.hpp"

#include <algorithm>

#include "readings/text_cells.hpp"

namespace reeve::readings {

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

}  // namespace reeve::readings
