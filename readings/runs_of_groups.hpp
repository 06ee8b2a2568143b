// A run is one mounting of one rig: rows of one run name that lie in several groups, as when the
// files of two rigs are put together, are so many runs.
#pragma once

#include <vector>

#include "readings/measured_data.hpp"

namespace reeve::readings {

// Where a column of groups was asked for: too few groups, rows without one.
std::vector<DataNote> notes_on_groups(const MeasuredData& data);

// Their names get the group's behind them: "1 (left)". Rows without a group are one of
// their own where there are two groups or more; beside one group they belong to it.
std::vector<DataNote> part_runs_by_group(MeasuredData& data);

}  // namespace reeve::readings
