// Rows of a file of measured tensions, one after the other, into readings.
#pragma once

#include "readings/measured_data.hpp"
#include "readings/rows.hpp"

namespace reeve::readings {

// All that is wrong with a row goes into the list of faults; what the readings are worth then, this
// does not say.
MeasuredData read_rows(CsvReader& csv, const Beginning& beginning,
                       const std::vector<DataColumn>& columns, const RoutingResolver& resolve,
                       const ReadingOptions& options, FaultList& faults);

}  // namespace reeve::readings
