#include "diagnosis/plan/measurement_plan.hpp"

#include <algorithm>

namespace reeve::diagnosis {

MeasurementPlan measurement_plan(const MeasuredData& data,
                                 const std::vector<MeasurableRouting>& further,
                                 const Noise& noise) {
  MeasurementPlan plan{&data, {}, noise};
  const auto add = [&](const MeasurableRouting& routing) {
    const bool known =
        std::any_of(plan.routings.begin(), plan.routings.end(),
                    [&](const MeasurableRouting& other) { return other.word == routing.word; });
    if (!known) plan.routings.push_back(routing);
  };
  for (const MeasuredRouting& measured : data.routings) add({measured.word, measured.routing});
  for (const MeasurableRouting& routing : further) add(routing);
  return plan;
}

std::optional<PlannedMeasurement> separating_measurement(const MeasurementPlan& plan,
                                                         const std::vector<Model>& models,
                                                         const std::vector<std::string>& names) {
  for (std::size_t i = 1; i < names.size(); ++i) {
    auto found = separating_measurement(plan, models[0], names[0], models[i], names[i]);
    if (found) return found;
  }
  return std::nullopt;
}

}  // namespace reeve::diagnosis
