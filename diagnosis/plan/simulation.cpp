#include "diagnosis/plan/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "causes/model_solver.hpp"
#include "core/error.hpp"
#include "diagnosis/fit/forecast.hpp"
#include "numerics/random.hpp"
#include "numerics/streams.hpp"

namespace reeve::diagnosis {
namespace {

// Tensions of one routing on the rig.
class Rig {
 public:
  Rig(const ExperimentPlan& plan, const PlannedRouting& routing, const Model& model,
      const Hardware& hardware)
      : routing_(routing),
        model_(model),
        channels_(plan.channels),
        mounted_(model, hardware, routing.word, routing.network) {
    for (const Segment& channel : channels_) {
      segments_.push_back(find_segment(routing.network, channel));
    }
  }

  // Returns the readings of the channels without noise.
  std::vector<std::optional<double>> read(const PlannedReading& planned) {
    const Grasp grasp = actual_grasp(model_, routing_.word, planned.grasp);
    const Conditions conditions = at_tendon(model_, planned.direction, planned.conditions);
    std::optional<ModelSolver> bent;
    if (planned.sheath_angle_rad) {
      bent.emplace(model_, bent_to(*planned.sheath_angle_rad), routing_.word, routing_.network);
    }
    ModelSolver& solver = bent ? *bent : mounted_;
    const TensionState& state = in_range(solver.solve(grasp, planned.direction, conditions), grasp);
    if (!solver.converged()) {
      throw InputError(fmt::format(
          "{}: in the grasp '{}' the tensions do not settle under these causes at {} N: expected "
          "smaller ones",
          routing_.label, to_text(grasp), planned.conditions.motor_tension_N));
    }
    std::vector<Sensor> sensors;
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      if (!segments_[c]) continue;
      sensors.push_back(
          {channels_[c], conditions.motor_tension_N * state.tension[*segments_[c]], c});
    }
    causes::read(model_, planned.direction, planned.conditions, sensors);
    std::vector<std::optional<double>> tensions(channels_.size());
    for (const Sensor& sensor : sensors) tensions[*sensor.column] = sensor.reading_N;
    return tensions;
  }

 private:
  const TensionState& in_range(const TensionState& state, Grasp grasp) const {
    try {
      return require_in_range(state, grasp);
    } catch (const OutOfRange& error) {
      throw error.at(routing_.label);
    }
  }

  Hardware bent_to(double sheath_angle_rad) const {
    Hardware hardware =
        effective_hardware(with_sheath_angle(model_.hardware, sheath_angle_rad), model_.effects);
    if (const auto found = fault(hardware)) throw InputError(sentence(*found));
    return hardware;
  }

  const PlannedRouting& routing_;
  const Model& model_;
  const std::vector<Segment>& channels_;
  std::vector<std::optional<std::size_t>> segments_;
  ModelSolver mounted_;  // with the hardware's own sheath angles
};

}  // namespace

Simulation simulate(const ExperimentPlan& plan, const Model& model, const AddedNoise& noise,
                    std::uint64_t seed) {
  Simulation simulation;
  simulation.readings = schedule(plan, seed);
  simulation.tension_N.reserve(simulation.readings.size());
  const Hardware hardware = effective_hardware(model);
  std::vector<Rig> rigs;
  rigs.reserve(plan.routings.size());
  for (const PlannedRouting& routing : plan.routings) {
    rigs.emplace_back(plan, routing, model, hardware);
  }
  std::uint64_t index = 0;
  std::uint64_t row = 0;
  for (PlannedReading& planned : simulation.readings) {
    std::vector<std::optional<double>> tensions = rigs[planned.routing].read(planned);
    for (std::optional<double>& tension : tensions) {
      const std::uint64_t here = index++;
      if (!tension) continue;
      ++simulation.values;
      *tension *= 1 + noise.relative * normal(seed, streams::relative_noise, here);
      *tension += noise.absolute_N * normal(seed, streams::absolute_noise, here);
      simulation.clipped += *tension < 0 ? 1 : 0;
      *tension = std::max(0.0, *tension);
    }
    simulation.tension_N.push_back(std::move(tensions));
    const double off = noise.motor_relative * normal(seed, streams::motor_noise, row++);
    planned.conditions.motor_tension_N *= std::max(0.0, 1 + off);
  }
  return simulation;
}

}  // namespace reeve::diagnosis
