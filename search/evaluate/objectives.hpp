// Objectives of a design: one table with name, unit, direction and function of each.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/hand.hpp"
#include "core/indicators.hpp"
#include "core/performance.hpp"

namespace reeve::search {

enum class Objective : std::uint8_t {
  uniformity_mean,
  uniformity_worst,
  efficiency_mean,
  efficiency_worst,
  force_transmission,
  jams,
  jams_all,
  sheaths,
  pulleys,
  knots,
  travel,
  round_trip_efficiency,
  adaptability,
  torsional_balance,
  reliability,
  authors_efficiency,
  transmission,
  score,
  blocks,
  finger_uniformity_mean,
  finger_uniformity_worst,
  parts,
  cost,
  uniformity_p5,
  efficiency_p5,
  motor_force,
  fingertip_force_mean,
  fingertip_force_worst,
  stroke,
  closure,
  motor_power,
};
inline constexpr std::size_t objective_count = 31;

using ObjectiveValues = std::array<double, objective_count>;

inline double value(const ObjectiveValues& values, Objective objective) {
  return values[static_cast<std::size_t>(objective)];
}

inline double& value(ObjectiveValues& values, Objective objective) {
  return values[static_cast<std::size_t>(objective)];
}

enum class Better : std::uint8_t { higher, lower };

// Contribution of one grasp: a weight and the performance in it.
struct GraspOutcome {
  double weight = 1;
  bool jams = false;
  Performance pull;
  double round_trip_efficiency = 0;
  Indicators indicators;
  GripDemand grip{};  // set if the hardware has a hand, which the grasp does not open
};

// The 5 % quantiles of the means over the grasps where no two contacts are alike
// (contact_quantiles.hpp).
struct ContactQuantiles {
  double uniformity = 0;
  double efficiency = 0;
};

// Outcome for the whole hand; 0 without one.
struct HandOutcome {
  double stroke_mm = 0;  // greatest of the motors; infinite if no finger of one can close
  double closure = 0;
  double close_s = 0;
  MotorArray strokes_mm{};          // of each motor
  bool leaves_out_springs = false;  // in series with tendons, whose stretch is not known
};

struct DesignOutcome {
  std::vector<GraspOutcome> grasps;
  PartCount parts;
  // Carriage travel per unit that a strand gives up, on average over the strands, when all fingers
  // close: without blocks, strands / motor-side segments. 0 without strands, infinite where the
  // carriage is blocked all the same.
  double travel = 0;
  // Cost of the parts; infinite without prices. (NaN would not equal itself.)
  double cost = std::numeric_limits<double>::infinity();
  // The number of sets of held fingers that jam, of all but that of all fingers
  // (core/tension/jamming.hpp).
  double jams_all = 0;
  ContactQuantiles where_contacts_scatter{};
  HandOutcome hand{};
};

// Greatest force of each motor over the grasps.
MotorArray motor_forces(const DesignOutcome& design);

// One row for each objective. Rows that differ in `part` only (mean, worst) are one thing for
// readers: one column, one key with two values.
struct ObjectiveRow {
  Objective objective;
  const char* name;     // uniformity_mean
  const char* family;   // uniformity
  const char* part;     // "mean", "worst", or ""
  const char* heading;  // heading of a narrow column
  const char* unit;
  Better better;
  int decimals;          // places in tables; counts have none
  unsigned dispensable;  // the greater, the sooner a narrow window drops it; 0: never
  bool on_demand;        // true if tables for people show it only on request
  const char* meaning;
  double (*compute)(const DesignOutcome&);  // null for the score, which is made of the others
  // Range of possible values, whatever the routing and its friction.
  std::optional<double> least = 0;
  std::optional<double> greatest{};
  bool of_hand = false;  // true if only hardware with a hand has it; 0 otherwise

  bool is_count() const { return decimals == 0; }
};

const std::array<ObjectiveRow, objective_count>& objective_table();
const ObjectiveRow& row(Objective objective);

// True if the values come from hardware with a hand: the stroke is then above 0.
inline bool has_hand(const ObjectiveValues& values) { return value(values, Objective::stroke) > 0; }
// True if the objective exists for this hardware.
inline bool is_there(const ObjectiveRow& row, const ObjectiveValues& values) {
  return !row.of_hand || has_hand(values);
}

// Rounded to 1e-10: far above rounding errors, so that designs that are equal on paper compare
// equal, and far below anything that can be measured. Never -0.
double on_grid(double value);

// All objectives on that grid, but the score (score.hpp), which is left at 0.
void compute_objectives(const DesignOutcome& outcome, ObjectiveValues& values);
// Only these; the others stay as they are.
void compute_objectives(const DesignOutcome& outcome, const std::vector<Objective>& objectives,
                        ObjectiveValues& values);

// Names as in the table; "uniformity" and "efficiency" are short for their means.
// Throws InputError that names the item and lists the objectives.
Objective parse_objective(const std::string& name, const std::string& option);
std::vector<Objective> parse_objectives(const std::string& text);

// "sheaths<=2": an objective, a comparison (<=, >=, <, >, ==) and a number.
struct Constraint {
  Objective objective;
  std::string comparison;
  double bound = 0;
  std::string text;

  bool admits(const ObjectiveValues& values) const;
};

// The number of the first constraint, from 1, that does not admit the values; 0: all do.
std::size_t first_failure(const std::vector<Constraint>& constraints,
                          const ObjectiveValues& values);

Constraint parse_constraint(const std::string& text);

}  // namespace reeve::search
