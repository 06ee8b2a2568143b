// Simulated readings: a planned experiment on a rig that the model describes, with noise.
//
//   reading = T (1 + r n_1) + a n_2, not below 0
//
// T is what the sensor would read without noise (the model's tension in the real grasp, under the
// reading's conditions, through the effects on the sensors), n_1 and n_2 are standard normal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "causes/model.hpp"
#include "diagnosis/plan/experiment.hpp"

namespace reeve::diagnosis {

struct AddedNoise {
  double relative = 0.02;
  double absolute_N = 0.05;
  double motor_relative = 0;  // noise of the recorded motor tension, not of the one that pulls
};

struct Simulation {
  std::vector<PlannedReading> readings;
  // Parallel to the readings and the plan's channels; empty where the routing has no such segment.
  std::vector<std::vector<std::optional<double>>> tension_N;
  std::size_t values = 0;
  std::size_t clipped = 0;  // values that would have been below 0
};

// The seed decides the conditions and the noise. Throws InputError that names the routing if the
// model has no solution there.
Simulation simulate(const ExperimentPlan& plan, const Model& model, const AddedNoise& noise,
                    std::uint64_t seed);

}  // namespace reeve::diagnosis
