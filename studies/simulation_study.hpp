// A planned experiment, simulated; and how often a diagnosis finds what is hidden in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "causes/model.hpp"
#include "diagnosis/plan/experiment.hpp"
#include "diagnosis/plan/power.hpp"
#include "diagnosis/plan/simulation.hpp"
#include "studies/study_supervision.hpp"

namespace reeve::studies {

struct SimulationReport {
  ExperimentPlan plan;
  Model model;
  AddedNoise noise;
  std::uint64_t seed = 1;
  std::string command;  // the command that makes it again
  Simulation simulation;
};

struct PowerReport {
  SimulationReport experiment;  // the first one
  std::vector<PowerTrial> trials;
};

// The data file of a simulation.
using WrittenSimulation = std::function<std::string(const SimulationReport&)>;

// So many experiments with seeds from that of the first on, each diagnosed from its file as its
// user would. Nothing if it was stopped.
std::optional<PowerReport> power_study(SimulationReport experiment, std::size_t experiments,
                                       const WrittenSimulation& written,
                                       const StudySupervision& supervision = {});

}  // namespace reeve::studies
