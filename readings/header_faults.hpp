// What is wrong with a file's header, in the list of the file's faults.
#pragma once

#include <cstddef>
#include <string>

#include "readings/csv.hpp"
#include "readings/fault_list.hpp"

namespace reeve::readings {

class HeaderFaults {
 public:
  // Both must outlive it.
  HeaderFaults(const CsvReader& csv, FaultList& faults) : csv_(csv), faults_(faults) {}

  // At the header's line, if the fault has no place of its own.
  void add(InputFault fault);
  void add_column(std::size_t column, std::string expected);

 private:
  const CsvReader& csv_;
  FaultList& faults_;
};

}  // namespace reeve::readings
