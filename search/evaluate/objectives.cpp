#include "search/evaluate/objectives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/text.hpp"

namespace reeve::search {
namespace {

using Grasps = std::vector<GraspOutcome>;

template <typename Get>
double mean(const Grasps& grasps, Get get, bool (*counts)(const GraspOutcome&) = nullptr) {
  double sum = 0;
  double weight = 0;
  for (const GraspOutcome& grasp : grasps) {
    if (counts != nullptr && !counts(grasp)) continue;
    sum += grasp.weight * get(grasp);
    weight += grasp.weight;
  }
  return sum / weight;
}

template <typename Get>
double worst(const Grasps& grasps, Get get) {
  double least = get(grasps.front());
  for (const GraspOutcome& grasp : grasps) least = std::min(least, get(grasp));
  return least;
}

double uniformity(const GraspOutcome& grasp) { return grasp.pull.uniformity; }
double finger_uniformity(const GraspOutcome& grasp) { return grasp.pull.finger_uniformity; }
double efficiency(const GraspOutcome& grasp) { return grasp.pull.efficiency; }
bool grips(const GraspOutcome& grasp) { return grasp.grip.weakest > 0; }
double fingertip_force(const GraspOutcome& grasp) {
  return grips(grasp) ? grasp.grip.force_per_motor_N : std::numeric_limits<double>::infinity();
}

double motor_force(const DesignOutcome& design) {
  return -worst(design.grasps, [](const GraspOutcome& g) { return -g.grip.motor_force_N; });
}

// Upper bound: greatest force over the whole stroke, of all motors together.
double motor_power(const DesignOutcome& design) {
  const MotorArray forces = motor_forces(design);
  constexpr double mm_in_m = 1000;
  double power = 0;
  for (std::size_t motor = 0; motor < max_carriages; ++motor) {
    if (!(forces[motor] > 0)) continue;
    if (std::isinf(forces[motor])) return forces[motor];
    power += forces[motor] * design.hand.strokes_mm[motor] / mm_in_m / design.hand.close_s;
  }
  return power;
}

constexpr std::array<ObjectiveRow, objective_count> table{{
    {Objective::uniformity_mean, "uniformity_mean", "uniformity", "mean", "uniformity", "1",
     Better::higher, 3, 0, false, "least over greatest strand tension, mean over the grasps",
     [](const DesignOutcome& d) { return mean(d.grasps, uniformity); }, 0, 1},
    {Objective::uniformity_worst, "uniformity_worst", "uniformity", "worst", "uniformity", "1",
     Better::higher, 3, 0, false, "least over greatest strand tension, in the worst grasp",
     [](const DesignOutcome& d) { return worst(d.grasps, uniformity); }, 0, 1},
    {Objective::efficiency_mean, "efficiency_mean", "efficiency", "mean", "efficiency", "1",
     Better::higher, 3, 0, false, "useful work over motor work, mean over the grasps",
     [](const DesignOutcome& d) { return mean(d.grasps, efficiency); }, 0, 1},
    {Objective::efficiency_worst, "efficiency_worst", "efficiency", "worst", "efficiency", "1",
     Better::higher, 3, 0, false, "useful work over motor work, in the worst grasp",
     [](const DesignOutcome& d) { return worst(d.grasps, efficiency); }, 0, 1},
    {Objective::force_transmission, "force_transmission", "force_transmission", "", "force", "1",
     Better::higher, 3, 3, false, "sum of strand tensions over motor tension, mean over the grasps",
     [](const DesignOutcome& d) {
       return mean(d.grasps, [](const GraspOutcome& g) { return g.pull.force_transmission; });
     }},
    {Objective::jams, "jams", "jams", "", "jams", "grasps", Better::lower, 0, 5, false,
     "grasps in which the carriage is blocked",
     [](const DesignOutcome& d) {
       return static_cast<double>(std::count_if(d.grasps.begin(), d.grasps.end(),
                                                [](const GraspOutcome& g) { return g.jams; }));
     }},
    {Objective::jams_all, "jams_all", "jams_all", "", "jams all", "grasps", Better::lower, 0, 5,
     false, "the same over all grasps, except all fingers held",
     [](const DesignOutcome& d) { return d.jams_all; }},
    {Objective::sheaths, "sheaths", "sheaths", "", "sheaths", "parts", Better::lower, 0, 6, false,
     "sheaths between hand and motor: one for each M, two for each P",
     [](const DesignOutcome& d) { return static_cast<double>(d.parts.sheaths); }},
    {Objective::pulleys, "pulleys", "pulleys", "", "pulleys", "parts", Better::lower, 0, 8, false,
     "parts with a bearing: P, B and fingertips with a bearing",
     [](const DesignOutcome& d) { return static_cast<double>(d.parts.pulleys); }},
    {Objective::knots, "knots", "knots", "", "knots", "parts", Better::lower, 0, 9, false,
     "closed loops, whose ends must be tied together",
     [](const DesignOutcome& d) { return static_cast<double>(d.parts.knots); }},
    {Objective::travel, "travel", "travel", "", "travel", "mm/mm", Better::lower, 2, 4, false,
     "carriage travel per mm that each strand gives up, all fingers closing, on average",
     [](const DesignOutcome& d) { return d.travel; }},
    {Objective::round_trip_efficiency, "round_trip_efficiency", "round_trip_efficiency", "",
     "round trip", "1", Better::higher, 3, 7, false,
     "motor tension releasing over pulling at equal strand work, mean over the grasps",
     [](const DesignOutcome& d) {
       return mean(d.grasps, [](const GraspOutcome& g) { return g.round_trip_efficiency; });
     },
     0, 1},
    {Objective::adaptability, "adaptability", "adaptability", "", "adaptability", "1",
     Better::higher, 2, 1, true,
     "10 x (1 - difference of the finger pulls / their sum), mean over the grasps",
     [](const DesignOutcome& d) {
       return mean(d.grasps, [](const GraspOutcome& g) { return g.indicators.adaptability; });
     },
     0, 10},
    {Objective::torsional_balance, "torsional_balance", "torsional_balance", "", "balance", "1",
     Better::higher, 2, 1, true,
     "10 x (1 - greatest difference of a finger's strands / sum of all), mean over the grasps",
     [](const DesignOutcome& d) {
       return mean(d.grasps, [](const GraspOutcome& g) { return g.indicators.torsional_balance; });
     },
     0, 10},
    {Objective::reliability, "reliability", "reliability", "", "reliability", "1", Better::higher,
     2, 1, true,
     "10 x (1 - greatest friction force at a contact / sum of all strands), mean over the grasps",
     [](const DesignOutcome& d) {
       return mean(d.grasps, [](const GraspOutcome& g) { return g.indicators.reliability; });
     },
     std::nullopt, 10},
    {Objective::authors_efficiency, "authors_efficiency", "authors_efficiency", "",
     "auth. efficiency", "1", Better::higher, 2, 1, true,
     "10 times work over motor work if all strands closed alike, mean over the grasps",
     [](const DesignOutcome& d) {
       return mean(d.grasps, [](const GraspOutcome& g) { return g.indicators.authors_efficiency; });
     }},
    {Objective::transmission, "transmission", "transmission", "", "transmission", "1",
     Better::higher, 2, 1, true,
     "10 times the mean strand tension over motor tension, mean over the grasps",
     [](const DesignOutcome& d) {
       return mean(d.grasps, [](const GraspOutcome& g) { return g.indicators.transmission; });
     }},
    {Objective::score, "score", "score", "", "score", "1", Better::higher, 2, 0, true,
     "weighted mean of objectives (default: the five above)", nullptr, std::nullopt},
    {Objective::blocks, "blocks", "blocks", "", "blocks", "parts", Better::lower, 0, 8, true,
     "floating blocks and bars at the hand, which move as the fingers close",
     [](const DesignOutcome& d) { return static_cast<double>(d.parts.blocks + d.parts.bars); }},
    {Objective::finger_uniformity_mean, "finger_uniformity_mean", "finger_uniformity", "mean",
     "fingers", "1", Better::higher, 3, 2, true,
     "least over greatest finger pull (sum of the finger's strands), mean over the grasps",
     [](const DesignOutcome& d) { return mean(d.grasps, finger_uniformity); }, 0, 1},
    {Objective::finger_uniformity_worst, "finger_uniformity_worst", "finger_uniformity", "worst",
     "fingers", "1", Better::higher, 3, 2, true,
     "least over greatest finger pull, in the worst grasp",
     [](const DesignOutcome& d) { return worst(d.grasps, finger_uniformity); }, 0, 1},
    {Objective::parts, "parts", "parts", "", "parts", "parts", Better::lower, 0, 8, true,
     "sheaths, pulleys, knots, floating blocks and bars together",
     [](const DesignOutcome& d) {
       const PartCount& p = d.parts;
       return static_cast<double>(p.sheaths + p.pulleys + p.knots + p.blocks + p.bars);
     }},
    {Objective::cost, "cost", "cost", "", "cost", "1", Better::lower, 2, 2, true,
     "cost of the parts, in the unit of the prices", [](const DesignOutcome& d) { return d.cost; }},
    {Objective::uniformity_p5, "uniformity_p5", "uniformity_p5", "", "uniformity, 5 %", "1",
     Better::higher, 3, 1, true, "5 % quantile of the mean uniformity where contacts differ",
     [](const DesignOutcome& d) { return d.where_contacts_scatter.uniformity; }, 0, 1},
    {Objective::efficiency_p5, "efficiency_p5", "efficiency_p5", "", "efficiency, 5 %", "1",
     Better::higher, 3, 1, true, "5 % quantile of the mean efficiency where contacts differ",
     [](const DesignOutcome& d) { return d.where_contacts_scatter.efficiency; }, 0, 1},
    {Objective::motor_force, "motor_force", "motor_force", "", "nominal motor", "N", Better::lower,
     1, 1, true, "motor tension at which every finger presses with its wanted force in every grasp",
     motor_force, 0, std::nullopt, true},
    {Objective::fingertip_force_mean, "fingertip_force_mean", "fingertip_force", "mean",
     "fingertip", "N/N", Better::higher, 3, 1, true,
     "fingertip force per newton of motor tension, least of the fingers, mean over the grasps",
     [](const DesignOutcome& d) { return mean(d.grasps, fingertip_force, grips); }, 0, std::nullopt,
     true},
    {Objective::fingertip_force_worst, "fingertip_force_worst", "fingertip_force", "worst",
     "fingertip", "N/N", Better::higher, 3, 1, true,
     "fingertip force per newton of motor tension, least of the fingers, in the worst grasp",
     [](const DesignOutcome& d) { return worst(d.grasps, fingertip_force); }, 0, std::nullopt,
     true},
    {Objective::stroke, "stroke", "stroke", "", "stroke", "mm", Better::lower, 1, 1, true,
     "carriage travel from the open hand to the closed one, or until the carriage is blocked",
     [](const DesignOutcome& d) { return d.hand.stroke_mm; }, 0, std::nullopt, true},
    {Objective::closure, "closure", "closure", "", "closure", "1", Better::higher, 3, 1, true,
     "least share of its range that a finger closes in this stroke",
     [](const DesignOutcome& d) { return d.hand.closure; }, 0, 1, true},
    {Objective::motor_power, "motor_power", "motor_power", "", "power", "W", Better::lower, 2, 1,
     true, "motor force times mean speed of the carriage: the most that a soft object asks for",
     motor_power, 0, std::nullopt, true},
}};

// Each stands for its mean.
constexpr std::array<std::string_view, 4> mean_families{"uniformity", "efficiency",
                                                        "finger_uniformity", "fingertip_force"};

std::vector<std::string> objective_names() {
  std::vector<std::string> names;
  for (const ObjectiveRow& row : table) names.emplace_back(row.name);
  return names;
}

// Returns the names that a user may write; for means also the family alone.
std::vector<std::string> names_for_objectives() {
  std::vector<std::string> names = objective_names();
  for (const std::string_view family : mean_families) names.emplace_back(family);
  return names;
}

void compute(const ObjectiveRow& row, const DesignOutcome& outcome, ObjectiveValues& values) {
  const bool is_there = row.compute != nullptr && (outcome.hand.stroke_mm > 0 || !row.of_hand);
  value(values, row.objective) = is_there ? on_grid(row.compute(outcome)) : 0;
}

}  // namespace

MotorArray motor_forces(const DesignOutcome& design) {
  MotorArray forces{};
  for (const GraspOutcome& grasp : design.grasps) {
    for (std::size_t motor = 0; motor < max_carriages; ++motor) {
      forces[motor] = std::max(forces[motor], grasp.grip.motors_N[motor]);
    }
  }
  return forces;
}

double on_grid(double value) {
  constexpr double grid = 1e10;
  return std::round(value * grid) / grid + 0.0;  // + 0.0 makes 0 of -0
}

const std::array<ObjectiveRow, objective_count>& objective_table() { return table; }

const ObjectiveRow& row(Objective objective) { return table[static_cast<std::size_t>(objective)]; }

void compute_objectives(const DesignOutcome& outcome, ObjectiveValues& values) {
  for (const ObjectiveRow& row : table) compute(row, outcome, values);
}

void compute_objectives(const DesignOutcome& outcome, const std::vector<Objective>& objectives,
                        ObjectiveValues& values) {
  for (const Objective objective : objectives) compute(row(objective), outcome, values);
}

Objective parse_objective(const std::string& name, const std::string& option) {
  if (std::find(mean_families.begin(), mean_families.end(), name) != mean_families.end()) {
    return parse_objective(name + "_mean", option);
  }
  for (const ObjectiveRow& row : table) {
    if (row.name == name) return row.objective;
  }
  throw InputError({.where = option,
                    .what = "unknown objective",
                    .value = name,
                    .expected = fmt::format(
                        "one of {}, or for means {}{}", fmt::join(objective_names(), ", "),
                        fmt::join(mean_families, ", "), did_you_mean(name, names_for_objectives())),
                    .form = InputForm::unknown});
}

std::vector<Objective> parse_objectives(const std::string& text) {
  std::vector<Objective> objectives;
  for (const std::string& item : comma_separated(text)) {
    const std::string name(trimmed(item));
    const std::string option = fmt::format("objectives '{}'", text);
    const Objective objective = parse_objective(name, option);
    if (std::find(objectives.begin(), objectives.end(), objective) != objectives.end()) {
      throw InputError({.where = option, .what = fmt::format("'{}' is named twice", name)});
    }
    objectives.push_back(objective);
  }
  return objectives;
}

bool Constraint::admits(const ObjectiveValues& values) const {
  const double v = value(values, objective);
  if (comparison == "<=") return v <= bound;
  if (comparison == ">=") return v >= bound;
  if (comparison == "<") return v < bound;
  if (comparison == ">") return v > bound;
  return v == bound;
}

std::size_t first_failure(const std::vector<Constraint>& constraints,
                          const ObjectiveValues& values) {
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    if (!constraints[c].admits(values)) return c + 1;
  }
  return 0;
}

Constraint parse_constraint(const std::string& text) {
  const std::size_t at = std::min(text.find_first_of("<>="), text.size());
  const std::size_t end = std::min(text.find_first_not_of("<>=", at), text.size());
  const std::string comparison = text.substr(at, end - at);
  const std::string number(trimmed(text.substr(end)));
  constexpr std::array<const char*, 5> known{"<=", ">=", "<", ">", "=="};
  const auto bound = number_in(number);
  if (std::find(known.begin(), known.end(), comparison) == known.end() || !bound) {
    throw InputError(
        {.what = "constraint",
         .value = text,
         .expected = "an objective, one of <= >= < > ==, and a number, such as sheaths<=2"});
  }
  const std::string name(trimmed(text.substr(0, at)));
  const std::string option = fmt::format("constraint '{}'", text);
  // On the grid of the values, so that a bound copied with all its digits holds.
  return {parse_objective(name, option), comparison, on_grid(*bound), name + comparison + number};
}

}  // namespace reeve::search
