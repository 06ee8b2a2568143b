#include "reports/sizing_objectives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/hand.hpp"
#include "core/text.hpp"
#include "search/evaluate/shown_objectives.hpp"

namespace reeve::reports {
namespace {

// Those of the goal and what is always shown; of a hand also what its motor must do, whatever it
// was sized for.
std::vector<Objective> objectives_of(const SizingReport& report) {
  std::vector<Objective> goal = report.options.goal.factors;
  if (hand(report.options.nominal.hardware)) {
    for (const Objective objective :
         {Objective::motor_force, Objective::stroke, Objective::closure}) {
      if (std::find(goal.begin(), goal.end(), objective) == goal.end()) goal.push_back(objective);
    }
  }
  return shown_objectives(Order(goal), report.options.score);
}

// Dimensions that suit the goal may ask more of the motor than it has.
std::vector<DocumentLine> motor_lines(const SizingReport& report) {
  const MotorParts& motor = report.options.nominal.hardware.motor;
  const ObjectiveValues& values = report.designs.front().design.after.values;
  std::vector<DocumentLine> lines;
  const auto compare = [&](const std::optional<double>& has, Objective objective,
                           const char* what) {
    const double needed = value(values, objective);
    if (!has || needed <= *has) return;
    const std::string wanted =
        std::isfinite(needed)
            ? fmt::format("{} {} would be needed", fixed(needed, row(objective).decimals),
                          row(objective).unit)
            : "none is";
    lines.push_back({fmt::format("The motor's {} of {:.4g} {} is not enough as it is sized: {}",
                                 what, *has, row(objective).unit, wanted),
                     true});
  };
  if (!hand(report.options.nominal.hardware)) return lines;
  compare(motor.force_N, Objective::motor_force, "force");
  compare(motor.stroke_mm, Objective::stroke, "stroke");
  return lines;
}

}  // namespace

Section objective_section(const SizingReport& report) {
  Table table{{text_column("objective"), text_column("unit"), number_column("before"),
               number_column("sized")},
              {}};
  const SizedDesign& design = report.designs.front().design;
  for (const Objective objective : objectives_of(report)) {
    const ObjectiveRow& about = row(objective);
    if (about.is_count()) continue;
    table.add({about.name, about.unit,
               fixed(value(design.before.values, objective), about.decimals),
               fixed(value(design.after.values, objective), about.decimals)});
  }
  return {"At the nominal coefficients", table, motor_lines(report)};
}

}  // namespace reeve::reports
