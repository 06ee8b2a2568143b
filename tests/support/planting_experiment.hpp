// Made-up experiments: which routings are measured in which runs, grasps and conditions, by which
// sensors. Nothing of what they will read.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "tests/support/planting_nature.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve::testing {

struct ExperimentRow {
  std::string run;
  Condition condition;                   // as recorded
  std::vector<std::string> measured;     // segments with a reading
  std::map<std::string, double> gain{};  // what mounting did to the sensors, by segment
};

struct Experiment {
  std::vector<std::string> channels;  // segments, in the order of the columns
  std::vector<ExperimentRow> rows;
};

// What an effect cannot be seen without.
struct ExperimentNeeds {
  bool speed = false, cycle = false, temperature = false;  // vary
  bool bearings = false;                                   // in most routings
  int runs = 0;                                            // so many; 0: 8 to 16
  double least_tension_N = 0.1;  // nominal tensions stay above, where that is possible
};

// 8 to 16 runs of 12 to 25 rows; 3 to 6 routings of two or three fingers, each in two runs or more;
// motor tensions of 5 to 60 N (less where the tensions of a release would break the tendon).
Experiment random_experiment(const ExperimentNeeds& needs, Dice& dice);

// Columns for every segment of the rows' routings that has a reading.
std::vector<std::string> channels_of(const std::vector<ExperimentRow>& rows);

// All strands, and the motor-side segments if they are asked for.
std::vector<std::string> sensors_of(const std::string& word, bool motor_side);

}  // namespace reeve::testing
