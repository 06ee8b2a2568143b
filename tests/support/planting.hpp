// Measured data with a hidden effect: simulated readings whose cause is known, to see whether a
// diagnosis finds it. Nothing here shares code with the causes that it is to judge.
//
// Oracle: how well the data could tell the truth from another model at best,
//
//     ln L(truth) - ln L(other) = sum over readings of ln p(reading | truth) - ln p(reading |
//     other)
//
// both with the noise as planted. A hidden effect whose ratio is small cannot be seen by anyone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/planting_effects.hpp"
#include "tests/support/planting_experiment.hpp"
#include "tests/support/planting_noise.hpp"

namespace reeve::testing {

struct PlantingPlan {
  std::vector<EffectKind> effects;  // none: the nominal model is the truth
  EffectSize size = EffectSize::medium;
  NoiseLevel noise = low_noise;
  int runs = 0;  // so many; 0: 8 to 16
};

struct PlantedCause {
  EffectKind kind = EffectKind::tube_friction;
  std::string name;  // as the diagnosis names it: sensor_gain[T3]
  std::vector<PlantedParameter> parameters;
  double log_likelihood_ratio = 0;  // of the truth over the truth without this cause
};

// One reading, in newton.
struct PlantedCell {
  std::size_t row = 0;  // in the experiment
  std::string channel;
  double nominal_N = 0;   // by the nominal model
  double expected_N = 0;  // by the truth, without noise
  double reading_N = 0;   // as printed
  double beyond_N = 0;    // of what its mounting does: more than the first order
};

struct Planted {
  std::string csv;
  std::vector<PlantedCause> causes;
  double log_likelihood_ratio = 0;  // of the truth over the nominal model
  NoiseLevel noise;
  Truth truth;
  Experiment experiment;
  std::vector<PlantedCell> cells;

  // Root of the mean squared distance of the readings, N.
  double rms_to_nominal_N() const;
  double rms_to_truth_N() const;
};

// The same plan and seed give the same bytes.
Planted plant(const PlantingPlan& plan, std::uint64_t seed);

// An experiment of one's own, with effects of one's own.
Planted measure(const Experiment& experiment, const std::vector<PlantedEffect>& effects,
                const NoiseLevel& noise, std::uint64_t seed);

// The same file with the rows of some runs once more, under other runs' names.
std::string with_copied_runs(const Planted& planted, std::size_t copies);

}  // namespace reeve::testing
