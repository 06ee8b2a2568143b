#include "reports/motor_words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/motor_sides.hpp"
#include "core/text.hpp"

namespace reeve::reports {
namespace {

std::string force_text(double force_N) {
  return std::isfinite(force_N) ? fixed(force_N, 1) + " N" : "no force is enough";
}

std::string enough_text(const MotorForce& force, double motor_N) {
  const std::string motor = fmt::format("The motor's {:.4g} N is ", motor_N);
  if (!std::isfinite(force.p95_N)) {
    return motor + "too little: in more than 5 % of the draws no force is enough";
  }
  return fmt::format("{}{}: 95 % of the draws need up to {} of it", motor,
                     force.is_met_by(motor_N) ? "enough" : "too little",
                     percent(force.p95_N / motor_N));
}

const char* springs_text(const MotorForce& force) {
  return force.leaves_out_springs ? ", if springs in series do not stretch" : "";
}

DocumentLine motor_line(const MotorForce& force, const MotorParts& motor) {
  const std::string text = fmt::format(
      "Motor force: {} nominal, {} in 95 % of {} draw{}{}", force_text(force.nominal_N),
      force_text(force.p95_N), force.draws, force.draws == 1 ? "" : "s", springs_text(force));
  if (!motor.force_N) return {text};
  return {text + ". " + enough_text(force, *motor.force_N), !force.is_met_by(*motor.force_N)};
}

// Returns no lines if the hand cannot move at all, which other lines say.
std::vector<DocumentLine> stroke_lines(const MotorForce& force, const MotorParts& motor) {
  if (!motor.stroke_mm || !std::isfinite(force.stroke_mm)) return {};
  const bool enough = force.stroke_mm <= *motor.stroke_mm;
  const char* where_enough = force.closure < 1 ? "enough for as far as the hand closes" : "enough";
  return {{fmt::format("The motor's stroke of {:.4g} mm is {}{}: {} of it {} needed",
                       *motor.stroke_mm, enough ? where_enough : "not enough", springs_text(force),
                       percent(force.stroke_mm / *motor.stroke_mm), enough ? "is" : "would be"),
           !enough || force.leaves_out_springs}};
}

// "Motors: M 65.8 N over 85.9 mm, M2 40.0 N over 21.3 mm"
std::vector<DocumentLine> lines_of_motors(const MotorForce& force) {
  if (force.motors.size() < 2) return {};
  std::vector<std::string> needs;
  for (const MotorNeed& need : force.motors) {
    const std::string name = motor_name(static_cast<int>(needs.size()) + 1);
    const std::string stroke = std::isfinite(need.stroke_mm)
                                   ? fmt::format("over {} mm", fixed(need.stroke_mm, 1))
                                   : "with its carriage blocked";
    needs.push_back(fmt::format("{} {} {}", name, force_text(need.force_N), stroke));
  }
  return {{fmt::format("Motors{}: {}", springs_text(force), fmt::join(needs, ", "))}};
}

Json motors_json(const std::vector<MotorNeed>& motors) {
  Json json = Json::array();
  for (const MotorNeed& need : motors) {
    json.push_back({{"motor", json.size() + 1},
                    {"force_N", number(need.force_N)},
                    {"stroke_mm", number(need.stroke_mm)}});
  }
  return json;
}

}  // namespace

std::vector<DocumentLine> motor_lines(const std::optional<MotorForce>& force,
                                      const MotorParts& motor) {
  if (!force) return {};
  std::vector<DocumentLine> lines = stroke_lines(*force, motor);
  lines.insert(lines.begin(), motor_line(*force, motor));
  append(lines, energy_lines(force->least_work_J, motor, force->motors.size()));
  append(lines, lines_of_motors(*force));
  return lines;
}

std::vector<DocumentLine> energy_lines(double least_work_J, const MotorParts& motor,
                                       std::size_t motors) {
  constexpr double mm_per_m = 1000;
  const double motor_J = static_cast<double>(motors) * motor.force_N.value_or(0) *
                         motor.stroke_mm.value_or(0) / mm_per_m;
  if (motor_J == 0 || motor_J >= least_work_J) return {};
  return {
      {fmt::format("{}{:.4g} N x {:.4g} mm = {:.3g} J is less than the {:.3g} J that the fingers "
                   "take: no routing can do it",
                   motors > 1 ? fmt::format("{} x ", motors) : "", *motor.force_N, *motor.stroke_mm,
                   motor_J, least_work_J),
       true}};
}

Json motor_force_json(const std::optional<MotorForce>& force, const MotorParts& motor) {
  if (!force) return nullptr;
  const auto is_enough = [&](double motor_N) { return Json(force->is_met_by(motor_N)); };
  const auto reaches = [&](double most_mm) {
    const bool enough = force->stroke_mm <= most_mm;
    return enough && force->leaves_out_springs ? Json(nullptr) : Json(enough);
  };
  Json json{{"nominal_N", number(force->nominal_N)},
            {"p95_N", number(force->p95_N)},
            {"draws", force->draws},
            {"seed", force->seed},
            {"is_enough", value_or_null(motor.force_N, is_enough)},
            {"stroke_mm", number(force->stroke_mm)},
            {"stroke_is_enough", value_or_null(motor.stroke_mm, reaches)}};
  if (force->motors.size() > 1) json["motors"] = motors_json(force->motors);
  return json;
}

}  // namespace reeve::reports
