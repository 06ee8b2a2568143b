#include "reports/results/count_report.hpp"

#include "reports/json.hpp"

namespace reeve::reports {

Sheet count_sheet(const RoutingCounts& counts, const PartSet& parts) {
  const std::string unit = parts.blocks > 0 ? "tree" : "tendon";
  Table table{{text_column("routings"), number_column("number")}, {}};
  table.add({"all", std::to_string(counts.all)});
  table.add({"every " + unit + " actuated", std::to_string(counts.actuated)});
  table.add({"actuated, one " + unit, std::to_string(counts.one_tendon)});
  return {{{"", table, {}}}};
}

std::string count_json(const RoutingCounts& counts) {
  return print(
      {{"all", counts.all}, {"actuated", counts.actuated}, {"one_tendon", counts.one_tendon}});
}

}  // namespace reeve::reports
