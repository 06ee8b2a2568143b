// Columns that are still empty in some rows (readings/filled_columns.hpp). A law of such a column
// would say nothing there, and its size would be that of the others, diluted. So these rows are
// left out, unless more than a third of all would be: then the column is not looked at. Fuller
// columns come first.
#pragma once

#include <cstddef>
#include <vector>

#include "readings/measured_data.hpp"

namespace reeve::diagnosis {

struct WholeColumns {
  MeasuredData data;  // readings in the same places, with a note for each such column
  std::vector<std::size_t> incomplete;  // readings to be left out, ascending
};

WholeColumns whole_columns(const MeasuredData& data);

}  // namespace reeve::diagnosis
