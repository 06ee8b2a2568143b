// Rows of a file of measured tensions, one after the other, into readings.
#pragma once

#include "readings/measured_data.hpp"
#include "readings/rows.hpp"

namespace reeve::readings {

// Reads all rows. Faults of a row go to the list of faults; the caller decides if the readings are
// still of use.
MeasuredData read_rows(CsvReader& csv, const Beginning& beginning,
                       const std::vector<DataColumn>& columns, const RoutingResolver& resolve,
                       const ReadingOptions& options, FaultList& faults);

}  // namespace reeve::readings
