#include "reports/rank_report.hpp"

#include "reports/json.hpp"

namespace reeve {

std::string rank_table(const RankReport& report) {
  return "Front by front over " + objective_names(report.objectives) +
         "; uniformity and efficiency as mean/worst over the grasps " + to_text(report.grasps) +
         "\n\n" + design_table(report.designs);
}

std::string rank_json(const RankReport& report) {
  Json json{{"designs", to_json(report.designs)},
            {"settings", settings_json(report.objectives, report.grasps, report.hardware)}};
  json["settings"]["uncertainty"] =
      report.uncertainty ? to_json(*report.uncertainty) : Json(nullptr);
  json["version"] = version_json();
  return print(json);
}

}  // namespace reeve
