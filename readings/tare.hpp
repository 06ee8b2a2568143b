// Zeros of the sensors: a row whose run or routing is called tare has what each sensor reads
// without load. It is taken off the readings below, until the next such row:
//
//   T = reading − zero
//
// Rows of zeros that follow one another are averaged. A cell that is empty keeps the zero from
// before.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "readings/note.hpp"
#include "readings/row_cells.hpp"

namespace reeve::readings {

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

}  // namespace reeve::readings
