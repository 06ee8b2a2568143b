// Columns that some rows leave empty, filled where the rest of their run tells what they were.
//
// An empty cell is filled by the better of two guesses from the cells of the column that its run
// records: the line between those before and behind it, as they were taken, or their mean. The
// guess is tried on all recorded cells: it has to meet them to within 40 % of what the column
// spans (medians of the distances from the guess, and from the median of all). What is left off
// then hardly changes the size of a law of the column: it scatters about the guess, and not the
// guess about it (J. Berkson, J. Am. Stat. Assoc. 45, 1950).
//
// Columns that are set row by row, and runs that record no cell, stay as they are.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "readings/measured_data.hpp"

namespace reeve::readings {

// A column that says under what conditions a reading was taken.
struct ConditionColumn {
  std::string name;
  std::function<std::optional<double>&(Reading&)> cell;
};
// speed_mm_s, cycle, temperature_C, and all covariates.
std::vector<ConditionColumn> condition_columns(const MeasuredData& data);

// Fills what it can, with a note for each column.
void fill_columns(MeasuredData& data);

}  // namespace reeve::readings
