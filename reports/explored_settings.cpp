#include "reports/explored_settings.hpp"

#include "reports/output/json.hpp"

namespace reeve::reports {

std::string differing_settings(const std::string& summary, const Model& model,
                               const GraspSet& grasps) {
  const Json explored = Json::parse(summary, nullptr, false);
  if (!explored.is_object() || !explored.contains("settings")) return "";
  const Json now = settings_json({}, authors_score(), grasps, model, 0);
  std::string differing;
  for (const char* key : {"hardware", "model", "grasps"}) {
    Json there = explored["settings"].value(key, Json(nullptr));
    if (there.is_object()) there.erase("unconverged");
    Json here = now[key];
    if (here.is_object()) here.erase("unconverged");
    if (there != here) differing += (differing.empty() ? "" : ", ") + std::string(key);
  }
  return differing;
}

}  // namespace reeve::reports
