// Readings far off that keep together, in words.
#pragma once

#include <string>

#include "diagnosis/verdict/outlier_groups.hpp"
#include "readings/measured_data.hpp"

namespace reeve::diagnosis {

// "T4 in runs m8 to m12", "T1 and T2 in run m3", "T4 in all runs".
std::string where_text(const OutlierGroups& together, const MeasuredData& data);

DataNote note_on(const OutlierGroups& together, const OutlierReadings& all,
                 const MeasuredData& data, double alpha);

}  // namespace reeve::diagnosis
