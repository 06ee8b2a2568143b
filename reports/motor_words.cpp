#include "reports/motor_words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/text.hpp"
#include "reports/document/text_table.hpp"

namespace reeve::reports {
namespace {

std::string force_text(double force_N) {
  return std::isfinite(force_N) ? fixed(force_N, 1) + " N" : "no force is enough";
}

std::string enough_text(const MotorForce& force, double motor_N) {
  const std::string motor = fmt::format("by the latter the motor's {:.4g} N ", motor_N);
  if (!std::isfinite(force.p95_N)) return motor + "is not enough";
  const std::string share = percent(force.p95_N / motor_N);
  return force.is_met_by(motor_N)
             ? fmt::format("{}is enough, {} of it are needed", motor, share)
             : fmt::format("{}is not enough, {} of it would be needed", motor, share);
}

DocumentLine motor_line(const MotorForce& force, const MotorParts& motor) {
  const std::string text =
      fmt::format("Motor force: {} nominal, {} in 95 % of {} draw{}", force_text(force.nominal_N),
                  force_text(force.p95_N), force.draws, force.draws == 1 ? "" : "s");
  if (!motor.force_N) return {text};
  return {text + "; " + enough_text(force, *motor.force_N), !force.is_met_by(*motor.force_N)};
}

}  // namespace

std::vector<DocumentLine> motor_lines(const std::optional<MotorForce>& force,
                                      const MotorParts& motor) {
  if (!force) return {};
  return {motor_line(*force, motor)};
}

std::vector<DocumentLine> stroke_lines(const ObjectiveValues& values, const MotorParts& motor) {
  const double stroke = value(values, Objective::stroke);
  if (!has_hand(values) || !motor.stroke_mm || stroke <= *motor.stroke_mm) return {};
  const std::string wanted =
      std::isfinite(stroke) ? fixed(stroke, 1) + " mm would be needed" : "none is";
  return {{fmt::format("The motor's stroke of {:.4g} mm is not enough as it is sized: {}",
                       *motor.stroke_mm, wanted),
           true}};
}

Json motor_force_json(const std::optional<MotorForce>& force, const MotorParts& motor) {
  if (!force) return nullptr;
  const auto is_enough = [&](double motor_N) { return Json(force->is_met_by(motor_N)); };
  return {{"nominal_N", number(force->nominal_N)},
          {"p95_N", number(force->p95_N)},
          {"draws", force->draws},
          {"seed", force->seed},
          {"is_enough", value_or_null(motor.force_N, is_enough)}};
}

}  // namespace reeve::reports
