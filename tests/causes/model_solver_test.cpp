// The tensions under exponents that depend on them: against an independent solver, and whether
// there are any.
#include "causes/model_solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/causes/rig.hpp"
#include "tests/support/reference_words.hpp"

namespace reeve {
namespace {

using testing::Dice;
using testing::effect;
using testing::ReferenceResult;
using testing::Solved;
using testing::Trial;

bool is_of_exponents(const Cause& cause) {
  return cause.reach() == Reach::load || cause.reach() == Reach::conditions;
}

// `share` of the range that is searched, about the nominal value.
Model random_model(Dice& dice, const Hardware& hardware, double share) {
  Model model{hardware};
  for (const Cause* cause : cause_library()) {
    if (!is_of_exponents(*cause) || dice.chance(0.4)) continue;
    Effect drawn = testing::random_effect(dice, *cause, hardware);
    drawn.values[0] *= share;
    add_effect(model, drawn);
  }
  model.conditions = testing::random_conditions(dice);
  return model;
}

int unconverged(double share, double least_motor_N, int trials) {
  int count = 0;
  for (int seed = 1; seed <= trials; ++seed) {
    const Trial trial = testing::random_trial(static_cast<std::uint64_t>(seed));
    Dice dice(static_cast<std::uint64_t>(seed) + 1'000'000);
    Model model = random_model(dice, trial.hardware, share);
    model.conditions.motor_tension_N = std::max(model.conditions.motor_tension_N, least_motor_N);
    const Solved s = testing::solved(model, trial.routing, trial.grasp, trial.direction);
    for (const double tension : s.state.tension) EXPECT_TRUE(std::isfinite(tension));
    count += s.converged ? 0 : 1;
  }
  return count;
}

// Forces of up to 0.1 N at motor tensions from 5 N on, laws to match. At the end of a tendon of a
// dozen contacts there is next to nothing left even so: some 4 of 10000 fail.
TEST(ModelSolver, ConvergesForNearlyAllEffectsOfTheUsualSize) {
  EXPECT_LE(unconverged(0.02, 5, 3000), 3);
}

// Forces of up to 5 N on each contact at motor tensions from 0.5 N on.
TEST(ModelSolver, SeldomFailsWhereForcesEatTheWholeTension) {
  EXPECT_LE(unconverged(1, 0, 3000), 30);
}

// ---- the laws again, for the independent solver ----

struct Law {
  double gamma = 0;    // load_dependent_friction
  double bending = 0;  // N
  double drag = 0;     // N
  double motor_N = 10;

  double exponent(const std::string& kind, double nominal, double high) const {
    const double T = high * motor_N;
    if (kind == "bearing") return with_force(nominal, T, drag);
    return with_force(nominal * std::pow(T / 10, -gamma), T, bending);
  }
  static double with_force(double phi, double high, double force) {
    const double low = high * std::exp(-phi) - force;
    return low > high * std::exp(-10.0) ? std::log(high / low) : 10;
  }
};

// Tensions and exponents in turn, half a step at a time.
ReferenceResult reference(const Trial& trial, const Mechanics& m, const Law& law) {
  const testing::ExponentsByName nominal = testing::exponents_by_name(trial.network, m);
  testing::ExponentsByName phi = nominal;
  for (int step = 0; step < 100; ++step) {
    const ReferenceResult result =
        testing::reference_tensions(to_word(trial.routing), trial.grasp, trial.direction,
                                    testing::reference_hardware(trial.network, m, phi));
    double change = 0;
    for (const testing::ReferenceContact& contact : result.contacts) {
      const testing::ContactName name{contact.left, contact.right};
      const double high =
          std::max(result.tension.at(contact.left), result.tension.at(contact.right));
      const double wanted = law.exponent(contact.kind, nominal.at(name), high);
      change = std::max(change, std::abs(wanted - phi.at(name)));
      phi.at(name) += 0.5 * (wanted - phi.at(name));
    }
    if (change < 1e-9) return result;
  }
  ADD_FAILURE() << "the reference does not settle";
  return {};
}

TEST(ModelSolver, AgreesWithAnIndependentSolverInAnOuterIteration) {
  int loops = 0;
  int released = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    const Trial trial = testing::random_trial(seed, {1, 3, true, true});
    SCOPED_TRACE(testing::to_text(trial));
    Dice dice(seed + 500);
    const Law law{dice.real(-0.2, 0.4), dice.real(0, 0.02), dice.real(0, 0.02),
                  dice.log_real(5, 50)};
    Model model = testing::model_with(
        {effect("load_dependent_friction", {law.gamma}), effect("bending_stiffness", {law.bending}),
         effect("bearing_drag", {law.drag})},
        trial.hardware);
    model.conditions.motor_tension_N = law.motor_N;
    const Solved s = testing::solved(model, trial.routing, trial.grasp, trial.direction);
    ASSERT_TRUE(s.converged);
    if (s.state.jams) continue;  // tendons without tension have no load
    const ReferenceResult expected =
        reference(trial, mechanics(trial.network, trial.hardware), law);
    for (const auto& [segment, tension] : expected.tension) {
      EXPECT_NEAR(s[segment], tension, 1e-6 * tension + 1e-9) << segment;
    }
    loops += trial.network.tendons[0].closed;
    released += trial.direction == Direction::release;
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(loops, 10);
  EXPECT_GT(released, 10);
}

// A loop that is opened at a seized contact begins elsewhere: its contacts keep their friction.
TEST(ModelSolver, GivesContactsThatSlideBesideASeizedOneTheirOwnRatios) {
  const std::string word = "1-T-2b-P-3-B-1";
  const Network network = expand(parse_routing(word));
  const Mechanics m = mechanics(network, {});
  int sliding = 0;
  for (std::size_t seized = 0; seized < network.contacts.size(); ++seized) {
    Subject subject;
    subject.routing = word;
    subject.contact = contact_name(network, seized);
    const Solved s = testing::solved(testing::model_with({effect("seized_contact", {}, subject)}),
                                     word, hold({2}));
    if (s.state.jams) continue;
    for (std::size_t k = 0; k < network.contacts.size(); ++k) {
      const auto [left, right] = ends_of(network.tendons[0], k);
      const double slip = s.state.slip[k];
      if (slip == 0 || s.state.tension[left] == 0) continue;
      EXPECT_NEAR(std::log(s.state.tension[right] / s.state.tension[left]),
                  std::copysign(m.phi[k], slip), 1e-9)
          << contact_name(network, k) << " beside " << subject.contact;
      ++sliding;
    }
  }
  EXPECT_GT(sliding, 20);
}

// The loop above in its own order, with the exponents of the load.
TEST(ModelSolver, GivesTheExponentsThatItsTensionsFollow) {
  const std::string word = "1-T-2b-P-3-B-1";
  const Network network = expand(parse_routing(word));
  Subject subject;
  subject.routing = word;
  int sliding = 0;
  for (std::size_t seized = 0; seized < network.contacts.size(); ++seized) {
    Model model = testing::model_with({effect("load_dependent_friction", {0.2})});
    subject.contact = contact_name(network, seized);
    add_effect(model, effect("seized_contact", {}, subject));
    ModelSolver solver(model, model.hardware, word, network);
    const TensionState& state = solver.solve(hold({2}), Direction::pull, model.conditions);
    const Mechanics& m = solver.solved();
    EXPECT_EQ(m.decay[seized], 0);
    for (std::size_t k = 0; k < network.contacts.size(); ++k) {
      const auto [left, right] = ends_of(network.tendons[0], k);
      if (k == seized || state.jams || state.slip[k] == 0 || state.tension[left] == 0) continue;
      const double drop = std::log(state.tension[right] / state.tension[left]);
      EXPECT_NEAR(drop, std::copysign(m.phi[k], state.slip[k]), 1e-9);
      EXPECT_NEAR(m.decay[k], std::exp(-std::abs(drop)), 1e-9);
      ++sliding;
    }
  }
  EXPECT_GT(sliding, 20);
}

// No solution begins where another ended: the same bytes come out whatever was solved before.
TEST(ModelSolver, ForgetsTheSolveBefore) {
  Model model = testing::model_with(
      {effect("load_dependent_friction", {0.3}), effect("bending_stiffness", {0.1})});
  const std::string word = "M-1-P-2-F";
  const Network network = expand(parse_routing(word));
  ModelSolver used(model, model.hardware, word, network);
  for (const double motor : {3.0, 30.0, 10.0}) {
    for (const WeightedGrasp& grasp : single_grasps(2)) {
      for (const Direction direction : {Direction::pull, Direction::release}) {
        model.conditions.motor_tension_N = motor;
        EXPECT_EQ(used.solve(grasp.grasp, direction, model.conditions).tension,
                  testing::solved(model, word, grasp.grasp, direction).state.tension);
      }
    }
  }
}

// One after the other in one solver is each in a solver of its own.
TEST(ModelSolver, GoesFromRoutingToRouting) {
  Model model = testing::model_with({effect("load_dependent_friction", {0.2})});
  Subject subject;
  subject.routing = "M-1-T-2-F";
  subject.contact = "T2-T3";
  add_effect(model, effect("seized_contact", {}, subject));
  ModelSolver solver(model);
  for (const char* word : {"1-P-2-P-1", "M-1-T-2-F", "M-1-F", "M-1-T-2-F", "M-1-T-2-F+M-3-F"}) {
    const Network network = expand(parse_routing(word));
    solver.set_routing(word, network, mechanics(network, model.hardware));
    const TensionState& state = solver.solve(Grasp{}, Direction::pull, model.conditions);
    EXPECT_EQ(state.tension, testing::solved(model, word).state.tension) << word;
  }
}

}  // namespace
}  // namespace reeve
