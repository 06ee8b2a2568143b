// Columns that some rows leave empty. A law of a column would say nothing in these rows, and its
// size would be that of the others, diluted.
//
// A cell is filled by the line between the recorded ones before and behind it in its run, as they
// were taken, where the column changes slowly: where such a line meets the recorded cells to within
// a tenth of what the column spans (medians of the distances from the line, and from the median).
// Otherwise the row is left out, unless more than a third of all rows are empty: then the column is
// not looked at.
//
// Nothing is filled beyond its run.
#pragma once

#include <cstddef>
#include <vector>

#include "readings/measured_data.hpp"

namespace reeve::diagnosis {

// The data, its readings in the same places, with a note for each column that is not whole.
struct FilledColumns {
  MeasuredData data;
  std::vector<std::size_t> incomplete;  // readings with an empty cell, ascending
};

FilledColumns filled_columns(const MeasuredData& data);

}  // namespace reeve::diagnosis
