// A planned experiment: which routing is mounted in which run, and under which conditions each
// reading is taken.
//
//   - A run is one mounting of one routing. Routings take turns, so that with twice as many runs as
//     routings each is mounted twice or more.
//   - Within a run, grasps with directions, motor tension, speed, temperature and sheath angle
//     vary, each in a random order of its own: levels of a list equally often, to within one; of a
//     range once in each of as many equal parts as the run has rows (of the logarithm for the
//     speed, on which friction depends by it). So no two of them go together but by chance.
//   - A further column varies likewise, or from run to run.
//   - The cycle rises evenly over the whole experiment: wear cannot be undone.
//
// The plan and the seed decide all of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "causes/cause.hpp"
#include "core/grasp.hpp"
#include "core/network.hpp"
#include "core/routing.hpp"

namespace reeve::diagnosis {

// Values of a condition: a range, or the levels of a list if it has any.
struct PlannedLevels {
  Range range;
  std::vector<double> list;
};

// A further recorded column, with another value in each reading, or in each run.
struct PlannedColumn {
  std::string name;
  PlannedLevels levels;
  bool by_run = false;
};

struct PlannedRouting {
  std::string label;  // in files: a word, or a name of the catalogue
  std::string word;
  Routing routing;
  Network network;
  std::vector<Grasp> grasps;
};

struct ExperimentPlan {
  std::vector<PlannedRouting> routings;
  std::vector<Direction> directions{Direction::pull};
  PlannedLevels motor_tension_N{{5, 60}, {}};
  std::optional<PlannedLevels> speed_mm_s;
  std::optional<PlannedLevels> cycle;
  std::optional<PlannedLevels> temperature_C;
  // angle of all sheaths; without it, the hardware's
  std::optional<PlannedLevels> sheath_angle_rad;
  std::vector<PlannedColumn> columns{};
  std::vector<Segment> channels;
  std::size_t runs = 12;
  std::size_t rows = 20;    // settings of the conditions per run
  std::size_t repeats = 1;  // readings under each
};

inline constexpr std::size_t max_planned_readings = 1'000'000;

// Throws InputError that begins with the option: "runs = 2: expected …".
void validate(const ExperimentPlan& plan);

// One reading to take. Conditions that the plan does not have are the reference ones.
struct PlannedReading {
  std::size_t run = 0;
  std::size_t routing = 0;  // in ExperimentPlan::routings
  std::size_t repeat = 0;
  Grasp grasp;
  Direction direction = Direction::pull;
  Conditions conditions;
  std::optional<double> sheath_angle_rad;
  std::vector<double> columns{};  // parallel to those of the plan
};

// In the order in which they are taken.
std::vector<PlannedReading> schedule(const ExperimentPlan& plan, std::uint64_t seed);

// Returns the kinds of cause that the experiment could show. Points into the plan.
Survey survey(const ExperimentPlan& plan);

}  // namespace reeve::diagnosis
