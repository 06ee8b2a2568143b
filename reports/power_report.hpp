// How often a planned experiment finds what is hidden in it, for people and programs.
#pragma once

#include <string>

#include "reports/document/document.hpp"
#include "studies/simulation_study.hpp"

namespace reeve::reports {

Document power_sheet(const PowerReport& report);
std::string power_json(const PowerReport& report);

}  // namespace reeve::reports
