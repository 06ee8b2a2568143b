// Tells the force and the stroke that a motor must have, and whether it does, in the same words
// everywhere.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/hardware.hpp"
#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "search/uncertainty/motor_force.hpp"

namespace reeve::reports {

// "Motor force: 65.8 N nominal, 84.2 N in 95 % of 1000 draws. The motor's 80 N is not enough for
// 95 % of the draws, which take 105 % of it", a line likewise of its stroke, and energy_lines.
// Several motors have a line for all, and each may pull with the motor's force.
// Returns no lines without a force.
std::vector<DocumentLine> motor_lines(const std::optional<MotorForce>& force,
                                      const MotorParts& motor);

// Says that force x stroke of all motors is less than the least work of the fingers, if it is.
std::vector<DocumentLine> energy_lines(double least_work_J, const MotorParts& motor,
                                       std::size_t motors);

Json motor_force_json(const std::optional<MotorForce>& force, const MotorParts& motor);

}  // namespace reeve::reports
