// One routing in full: tensions, shares and sliding directions in each grasp.
#pragma once

#include <string>
#include <vector>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/network.hpp"
#include "core/performance.hpp"
#include "core/tension.hpp"
#include "reports/json.hpp"
#include "reports/sheet.hpp"
#include "search/objectives.hpp"

namespace reeve {

struct ShownGrasp {
  Grasp grasp;
  TensionState state;
  Performance performance;
};

struct ShowReport {
  std::string word;
  std::string canonical;
  std::string name;  // "" if it has none
  Direction direction = Direction::pull;
  Model model;
  std::uint64_t unconverged = 0;  // tension solves
  Network network;
  std::vector<ShownGrasp> grasps;
  ObjectiveValues values{};  // over these grasps
};

// A contact, "T1-a", and in each grasp whether the tendon slides there: "T1->a", "a->T1" or "no".
struct ShownContact {
  std::string between;
  std::string kind;
  std::vector<std::string> slides;
};
std::vector<ShownContact> shown_contacts(const ShowReport& report);

Sheet show_sheet(const ShowReport& report);
Json to_json(const ShowReport& report);
std::string show_json(const ShowReport& report);
// The routing's schematic: in one grasp, or without any its parts alone.
std::string show_svg(const ShowReport& report, const ShownGrasp* shown);

}  // namespace reeve
