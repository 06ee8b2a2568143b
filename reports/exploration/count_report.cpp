#include "reports/exploration/count_report.hpp"

#include "reports/exploration/part_words.hpp"

namespace reeve::reports {

Document count_sheet(const CountReport& report) {
  const std::string unit = report.parts.blocks > 0 ? "tree" : "tendon";
  Table table{{text_column("routings"), number_column("number")}, {}};
  table.add({"all", std::to_string(report.counts.all)});
  table.add({"every " + unit + " actuated", std::to_string(report.counts.actuated)});
  table.add({"actuated, one " + unit, std::to_string(report.counts.one_tendon)});
  std::vector<DocumentLine> lines{{"Parts: " + parts_text(report.parts)}};
  if (report.left_out) lines.push_back({left_out_text(*report.left_out)});
  if (!report.limited) return {{{"", table, lines}}};
  for (std::size_t c = 0; c < report.constraints.size(); ++c) {
    table.add({"actuated, first to fail " + report.constraints[c].text,
               std::to_string(report.limited->rejected[c])});
  }
  table.add({"actuated, all constraints met", std::to_string(report.limited->meeting)});
  table.add({"… and one " + unit, std::to_string(report.limited->one_tendon)});
  return {{{"", table, lines}}};
}

std::string count_json(const CountReport& report) {
  const RoutingCounts& counts = report.counts;
  Json json{{"all", counts.all}, {"actuated", counts.actuated}, {"one_tendon", counts.one_tendon}};
  json["parts"] = parts_json(report.parts);
  json["left_out"] = left_out_json(report.left_out);
  if (!report.limited) return print(json);
  json["constraints"] = Json::array();
  for (std::size_t c = 0; c < report.constraints.size(); ++c) {
    json["constraints"].push_back(
        {{"constraint", report.constraints[c].text}, {"rejected", report.limited->rejected[c]}});
  }
  json["meeting"] = report.limited->meeting;
  json["meeting_one_tendon"] = report.limited->one_tendon;
  return print(json);
}

}  // namespace reeve::reports
