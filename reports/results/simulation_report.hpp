// Simulated readings as a file of measured data (docs/data.md): comment lines that say that they
// are simulated and how, and one row for each reading.
#pragma once

#include <cstdint>
#include <string>

#include "causes/model.hpp"
#include "diagnosis/plan/experiment.hpp"
#include "diagnosis/plan/simulation.hpp"

namespace reeve {

struct SimulationReport {
  ExperimentPlan plan;
  Model model;
  AddedNoise noise;
  std::uint64_t seed = 1;
  std::string command;  // that makes it again
  Simulation simulation;
};

std::string simulation_csv(const SimulationReport& report);
// What was written, in one line.
std::string simulation_summary(const SimulationReport& report, const std::string& file);

// "wear (change = -0.4, cycles = 300)" for each effect; "no cause" without any.
std::string hidden_text(const Model& model);

}  // namespace reeve
