// Models and solutions for the tests of causes.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "causes/library.hpp"
#include "causes/model.hpp"
#include "causes/model_solver.hpp"
#include "core/notation.hpp"
#include "tests/core/network_of.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve::testing {

inline Effect effect(const std::string& cause, std::vector<double> values, Subject subject = {}) {
  return {find_cause(cause), std::move(subject), std::move(values)};
}

inline Model model_with(std::vector<Effect> effects, const Hardware& hardware = {}) {
  Model model{hardware};
  for (Effect& effect : effects) add_effect(model, std::move(effect));
  return model;
}

inline Subject of_channel(const std::string& channel) {
  Subject subject;
  subject.channel = parse_segment(channel);
  return subject;
}

// Tensions in N per N of motor tension.
struct Solved : SolvedNetwork {
  bool converged = true;
};

inline Solved solved(const Model& model, const Routing& routing, Grasp grasp = {},
                     Direction direction = Direction::pull) {
  Solved result;
  result.network = expand(routing);
  ModelSolver solver(model, effective_hardware(model), to_word(routing), result.network);
  result.state = solver.solve(grasp, direction, model.conditions);
  result.converged = solver.converged();
  return result;
}

inline Solved solved(const Model& model, const std::string& word, Grasp grasp = {},
                     Direction direction = Direction::pull) {
  return solved(model, parse_routing(word), grasp, direction);
}

// The exponents of the default hardware.
inline constexpr double pi = std::numbers::pi;
inline constexpr double sheath = 0.36 * pi;
inline constexpr double tube = 0.18 * pi;
inline constexpr double bearing = 0.001 * pi;

// A sheath alone: what is left of 1 N.
inline double bench(const Model& model, Direction direction = Direction::pull) {
  return solved(model, "M-F", {}, direction)["h1"];
}

// A random value of every parameter, over the whole range that is searched.
inline Effect random_effect(Dice& dice, const Cause& cause, const Hardware& hardware) {
  Effect effect{&cause, {}, {}};
  for (const Parameter& parameter : cause.parameters(hardware)) {
    effect.values.push_back(dice.real(parameter.range.low, parameter.range.high));
  }
  return effect;
}

inline Conditions random_conditions(Dice& dice) {
  return {dice.log_real(0.5, 200), dice.log_real(0.1, 1000), dice.log_real(1, 1e5),
          dice.real(-10, 60), dice.real(0, 1)};
}

}  // namespace reeve::testing
