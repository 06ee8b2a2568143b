#include "reports/exploration/store_description.hpp"

#include <algorithm>

#include "reports/exploration/exploration_id.hpp"
#include "reports/exploration/explore_report.hpp"
#include "reports/output/json.hpp"

namespace reeve::reports {

Description store_description(const ExploreReport& planned,
                              const std::vector<std::string>& arguments) {
  Description description{
      whole_exploration_id(planned), version_json(), Json(arguments).dump(), {}};
  Json settings = explore_settings(planned);
  settings.erase("shard");
  if (settings["model"].is_object()) settings["model"].erase("unconverged");
  for (const auto& [key, value] : settings.items()) {
    description.settings.push_back(
        {key, value.dump(-1, ' ', false, Json::error_handler_t::replace)});
  }
  std::sort(description.settings.begin(), description.settings.end(),
            [](const StoredSetting& a, const StoredSetting& b) { return a.key < b.key; });
  description.known = planned.reference_names;
  for (const Constraint& constraint : planned.options.constraints) {
    description.limits.push_back(constraint.text);
  }
  return description;
}

}  // namespace reeve::reports
