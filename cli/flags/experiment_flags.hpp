// The experiment that `reeve simulate` plans, as options.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "cli/outputs.hpp"
#include "diagnosis/plan/experiment.hpp"
#include "diagnosis/plan/simulation.hpp"

namespace reeve::cli {

struct ExperimentFlags {
  std::string routings;
  std::string grasps = "single";
  std::string directions = "pull";
  std::string channels = "strands";
  std::string motor_tension = "5:60";
  TextOption speed;
  TextOption cycles;
  TextOption temperature;
  TextOption sheath_angle;
  std::vector<std::string> columns;
  std::vector<std::string> run_columns;
  std::string noise_relative = "0.02";
  std::string noise_absolute = "0.05";
  std::string noise_motor = "0";
  std::size_t runs = 12;
  std::size_t rows = 20;
  std::size_t repeats = 1;

  void add_to(CLI::App& command);
  // Both throw InputError that names option, value and what was expected.
  ExperimentPlan read_plan(const Catalogue& catalogue) const;
  AddedNoise read_noise() const;
};

}  // namespace reeve::cli
