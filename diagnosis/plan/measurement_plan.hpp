// From which measurements the next one is chosen, and which of them tells explanations apart.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/plan/next_measurement.hpp"

namespace reeve::diagnosis {

// The data's routings first: what is on the rig is easiest to measure again. `data` must outlive
// the plan.
MeasurementPlan measurement_plan(const MeasuredData& data,
                                 const std::vector<MeasurableRouting>& further, const Noise& noise);

// Of explanations that the data cannot tell apart, the first from the first other one that some
// measurement tells from it; some nothing on this rig does.
std::optional<PlannedMeasurement> separating_measurement(const MeasurementPlan& plan,
                                                         const std::vector<Model>& models,
                                                         const std::vector<std::string>& names);

}  // namespace reeve::diagnosis
