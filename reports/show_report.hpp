// One routing in full: tensions, shares and sliding directions in each grasp.
#pragma once

#include <string>
#include <vector>

#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "studies/shown_routing.hpp"

namespace reeve::reports {

// A contact, "T1-a", and in each grasp whether the tendon slides there: "T1->a", "a->T1" or "no".
struct ShownContact {
  std::string between;
  std::string kind;
  std::vector<std::string> slides;
};
std::vector<ShownContact> shown_contacts(const SolvedRouting& report);

// The name of each grasp that it was solved in.
std::vector<std::string> grasp_names(const SolvedRouting& report,
                                     std::string (*name_of)(const Network&, const ShownGrasp&));

// Words in which the tension table of a text differs from that of a page.
struct ShownWords {
  std::string grasp;  // heading of the grasps
  std::string unit;   // unit of tensions
  std::string transmission;
  std::vector<std::string> grasps;  // their names
};
Table tension_table(const SolvedRouting& report, const ShownWords& words);
// `grasps` are their headings.
Table contact_table(const SolvedRouting& report, const std::vector<std::string>& grasps);
Table objective_list(const ShownRouting& report);

Document show_document(const ShownRouting& report);
Json to_json(const ShownRouting& report);
std::string show_json(const ShownRouting& report);
// The routing's schematic: in one grasp, or without any its parts alone. Identifiers in it begin
// with `ids`.
std::string show_svg(const SolvedRouting& report, const ShownGrasp* shown,
                     const std::string& ids = "schematic");

}  // namespace reeve::reports
