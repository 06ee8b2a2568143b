// How often a planned experiment finds what is hidden in it, for people and programs.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/plan/power.hpp"
#include "reports/results/simulation_report.hpp"
#include "reports/sheet/sheet.hpp"

namespace reeve {

struct PowerReport {
  SimulationReport experiment;  // the first one
  std::vector<PowerTrial> trials;
};

Sheet power_sheet(const PowerReport& report);
std::string power_json(const PowerReport& report);

}  // namespace reeve
