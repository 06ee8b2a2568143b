// Where the rows of a file begin: the row below the header is one of units, or the first reading.
// Throws InputError if it is the header, below a line of other names such as a logger's channels.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "readings/csv.hpp"
#include "readings/fault_list.hpp"
#include "readings/note.hpp"
#include "readings/reading_options.hpp"

namespace reeve::readings {

struct Beginning {
  std::optional<CsvRow> units;
  std::optional<CsvRow> first;
  bool is_broken = false;  // neither it nor what follows can be read
};

Beginning read_beginning(CsvReader& csv, const ReadingOptions& options, FaultList& faults);

// From the first one up to the end, or to where the file breaks off, which is a fault.
void each_row(CsvReader& csv, const Beginning& beginning, FaultList& faults,
              const std::function<void(const CsvRow&)>& read);

// Of samples or readings. Throws InputError if there are none, and says whether there are zeros.
void require_rows(const CsvReader& csv, std::size_t rows, const std::vector<DataNote>& notes);

}  // namespace reeve::readings
