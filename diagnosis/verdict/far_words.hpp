// Readings far off that keep together, in words.
#pragma once

#include <string>

#include "diagnosis/verdict/far_together.hpp"
#include "readings/measured_data.hpp"

namespace reeve::diagnosis {

// "T4 in runs m8 to m12", "T1 and T2 in run m3", "T4 in all runs".
std::string where_text(const FarTogether& together, const MeasuredData& data);

DataNote note_on(const FarTogether& together, const FarReadings& all, const MeasuredData& data,
                 double alpha);

}  // namespace reeve::diagnosis
