#include "diagnosis/data/intake/beginning.hpp"

#include <utility>

#include "core/error.hpp"
#include "diagnosis/data/intake/column_units.hpp"

namespace reeve::diagnosis {

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
  return result;
}

void each_row(CsvReader& csv, const Beginning& beginning, FaultList& faults,
              const std::function<void(const CsvRow&)>& read) {
  if (beginning.is_broken) return;
  CsvRow row;
  if (beginning.first) read(*beginning.first);
  try {
    while (csv.next(row)) read(row);
  } catch (const InputError& error) {
    faults.add(row.line + 1, "where the rest cannot be read", error.fault());
  }
}

}  // namespace reeve::diagnosis
