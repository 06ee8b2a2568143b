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

Document show_document(const ShownRouting& report);
Json to_json(const ShownRouting& report);
std::string show_json(const ShownRouting& report);
// The routing's schematic: in one grasp, or without any its parts alone.
std::string show_svg(const SolvedRouting& report, const ShownGrasp* shown);

}  // namespace reeve::reports
