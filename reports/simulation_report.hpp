// Simulated readings as a file of measured data (docs/data.md): comment lines that say that they
// are simulated and how, and one row for each reading.
#pragma once

#include <string>

#include "reports/document/document.hpp"
#include "studies/simulation_study.hpp"

namespace reeve::reports {

std::string simulation_csv(const SimulationReport& report);
// Summarizes the written file in one line.
std::string simulation_summary(const SimulationReport& report, const std::string& file);

// "wear (change = -0.4, cycles = 300)" for each effect; "no cause" without any.
std::string hidden_text(const Model& model);

// How often a planned experiment finds what is hidden in it.
Document power_sheet(const PowerReport& report);
std::string power_json(const PowerReport& report);

}  // namespace reeve::reports
