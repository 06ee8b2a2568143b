#include "search/uncertainty/motor_force.hpp"

#include <algorithm>
#include <limits>

#include "core/error.hpp"
#include "core/hand.hpp"
#include "search/evaluate/evaluation.hpp"

namespace reeve::search {

namespace {

// A contact with more friction than any has passes no force on.
constexpr double no_force = std::numeric_limits<double>::infinity();

double quantile(const Routing& routing, const UncertaintyOptions& options) {
  try {
    validate(options, 1);
    const auto model = [&](std::uint64_t draw) { return draw_model(options, draw); };
    const auto bands = drawn_bands({routing}, {Objective::motor_force}, options, model);
    return bands->front().front().band.high;
  } catch (const InputError&) {
    return no_force;
  } catch (const OutOfRange&) {
    return no_force;
  }
}

std::vector<MotorNeed> motor_needs(const DesignOutcome& design, int motors) {
  const MotorArray forces = motor_forces(design);
  std::vector<MotorNeed> needs;
  for (std::size_t motor = 0; motor < static_cast<std::size_t>(motors); ++motor) {
    needs.push_back({on_grid(forces[motor]), on_grid(design.hand.strokes_mm[motor])});
  }
  return needs;
}

}  // namespace

std::optional<MotorForce> motor_force(const Routing& routing, const UncertaintyOptions& options) {
  const EvaluationScope scope =
      scope_for({Objective::motor_force, Objective::stroke, Objective::closure}, options.score);
  DesignEvaluator evaluator(options.nominal, options.grasps, options.score);
  const DesignOutcome& design = evaluator.outcome(routing, scope);
  ObjectiveValues values{};
  compute_objectives(design, values);
  if (!has_hand(values)) return std::nullopt;
  return MotorForce{
      .nominal_N = value(values, Objective::motor_force),
      .p95_N = quantile(routing, options),
      .draws = options.draws,
      .seed = options.seed,
      .ranges = options.ranges,
      .stroke_mm = value(values, Objective::stroke),
      .closure = value(values, Objective::closure),
      .leaves_out_springs = design.hand.leaves_out_springs,
      .least_work_J = least_work_J(options.nominal.hardware, finger_count(routing), options.grasps),
      .motors = motor_needs(design, carriage_count(routing))};
}

double least_work_J(const Hardware& hardware, int fingers, const GraspSet& grasps) {
  const auto known = hand(hardware);
  if (!known) return 0;
  const Hand ideal = without_guides(*known);
  double most_Nmm = 0;
  for (const WeightedGrasp& weighted : grasps) {
    double work_Nmm = 0;
    for (int number = 1; number <= fingers; ++number) {
      if (weighted.grasp.holds(number)) continue;
      const HandFinger& finger = ideal.finger(number);
      const FingerPull unit{1, 0};
      work_Nmm += core::motor_force(finger, false, unit) * finger.excursion_mm;
    }
    most_Nmm = std::max(most_Nmm, work_Nmm);
  }
  constexpr double Nmm_per_J = 1000;
  return most_Nmm / Nmm_per_J;
}

}  // namespace reeve::search
