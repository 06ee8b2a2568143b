// Runs in words.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/verdict/outlier_groups.hpp"
#include "readings/measured_data.hpp"

namespace reeve::diagnosis {

// Readings far off that keep together, in words.
// "T4 in runs m8 to m12", "T1 and T2 in run m3", "T4 in all runs".
std::string where_text(const OutlierGroups& together, const MeasuredData& data);

DataNote note_on(const OutlierGroups& together, const OutlierReadings& all,
                 const MeasuredData& data, double alpha);

// "A, B and C".
std::string listed(const std::vector<std::string>& names);

// "run m3", "runs m8 to m12", "runs m1, m3 and m4", "all runs"; and of names that say it
// themselves "run 5 and run 11". Ascending, at least one.
std::string runs_text(const std::vector<std::size_t>& runs, const MeasuredData& data);

}  // namespace reeve::diagnosis
