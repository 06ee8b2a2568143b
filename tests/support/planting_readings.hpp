// What the sensors of an experiment would read without noise, and the file that holds readings.
#pragma once

#include <string>
#include <vector>

#include "tests/support/planting_effects.hpp"
#include "tests/support/planting_experiment.hpp"

namespace reeve::testing {

// In newton, parallel to the experiment's rows and to what each measures.
using Readings = std::vector<std::vector<double>>;

Readings expected_readings(const Truth& truth, const Experiment& experiment);

// The file's number of a reading: four decimals.
double as_printed(double reading_N);

// With columns for what any row has, and a first comment line that says `simulated`.
std::string to_csv(const Experiment& experiment, const Readings& readings,
                   const std::string& comment);

}  // namespace reeve::testing
