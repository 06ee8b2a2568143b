// Tensions of a routing under a model whose exponents may depend on the conditions and on the
// tensions themselves.
//
// The exponents of the plain model are changed by each effect in turn, phi' = f(phi, T_high); where
// one depends on the tension, tensions and exponents are solved in turn until the exponents no
// longer change (to 1e-10, relative), by Newton's method (exponent_step.hpp), which goes on from
// the last load of the same motion. Where that does not end, each exponent goes to what its tension
// asks for: behind a motor-side segment a contact's exponent depends on those before it only, so
// that this ends after about as many rounds as there are contacts in a row. Where the tension falls
// towards the motor (release), a higher exponent raises the tension on which it depends, and a
// force lowers it in return, by F / T_low: an exponent that turns back goes only half as far the
// next time.
#pragma once

#include <string>
#include <vector>

#include "causes/exponent_step.hpp"
#include "causes/model.hpp"
#include "core/mechanics.hpp"
#include "core/tension/seizure.hpp"
#include "core/tension/tension.hpp"

namespace reeve::causes {

// A contact as the last solve left it.
struct SolvedContact {
  ContactKind kind = ContactKind::tube;
  int finger = 0;
  std::size_t number = 0;  // index among those of its kind in the routing's network, from 0
  double phi = 0;
  double high = 0;  // the larger of the tensions beside it, per N of motor tension
};

// One routing after the other under one model, in any grasp and under any conditions. Keeps its
// memory: but for routings with a seized contact, nothing is allocated in the steady state.
class ModelSolver {
 public:
  // `model` is kept by reference.
  explicit ModelSolver(const Model& model);

  // `word` says which routing the effects on routings mean; `plain` is what the effective hardware
  // makes of the network.
  void set_routing(const std::string& word, const Network& network, const Mechanics& plain);

  // The same routing with other friction.
  void set_friction(const Mechanics& plain);

  // For one routing alone. `hardware` is the effective one (a row's own sheath angle is in it
  // already), without fault.
  ModelSolver(const Model& model, const Hardware& hardware, const std::string& word,
              const Network& network);

  // At T_M = 1, in the order of the network's segments, if it is in range. `grasp` is the real one,
  // and the motor tension of the conditions that at the tendon (at_tendon).
  const TensionState& solve(Grasp grasp, Direction direction, const Conditions& conditions);

  // The same in a pull, exponents to 1e-6, from those of the last solve on. By Newton's method
  // alone, for routings without floating blocks. Of a given take-up the tensions are the relative
  // ones, t_i (TensionSolver::solve_relative); `unit_N` is the tension where t_i is 1.
  const TensionState& solve_from_last(Grasp grasp, Prescribed prescribed, double unit_N,
                                      const Conditions& conditions);

  // The routing at hand as it moves, split where a contact is seized, and its plain mechanics.
  const Network& network() const { return seized_.network; }
  const Mechanics& plain() const { return plain_; }

  // The routing's mechanics with the exponents of the last solve, in the order of its own network.
  // A seized contact has a decay of 0: nothing goes past it.
  const Mechanics& solved();

  // True if the last solve converged.
  bool converged() const { return converged_; }

  // All but seized ones.
  std::vector<SolvedContact> contacts() const;

 private:
  void guess_exponents(Direction direction, const Conditions& conditions);
  bool can_go_on(Grasp grasp, Direction direction) const;
  void solve_tensions(Grasp grasp, Direction direction);
  void solve_tensions_again(Grasp grasp, Direction direction);
  void settle_afresh(Grasp grasp, Direction direction, const Conditions& conditions);
  void begin_newton(const Conditions& conditions);
  bool settle_by_newton(Grasp grasp, Direction direction, const Conditions& conditions,
                        double tolerance);
  double compare_exponents(Direction direction, const Conditions& conditions);
  bool settle_in_turn(Grasp grasp, Direction direction, const Conditions& conditions);
  double change_exponents(Direction direction, const Conditions& conditions);
  void restart_steps();
  void set_exponent(std::size_t contact, double phi);
  double high_N(std::size_t contact) const;
  double exponent(std::size_t contact, double high_N, Direction direction,
                  const Conditions& conditions) const;

  const Model* model_;
  std::string word_;
  Grasp grasp_;
  Direction direction_ = Direction::pull;
  Prescribed prescribed_ = Prescribed::motor_tension;
  double unit_N_ = 1;  // tension of a segment whose tension in the state is 1
  std::vector<const Effect*> exponent_effects_;
  bool depends_on_load_ = false;
  SeizedNetwork seized_;
  Mechanics plain_;
  Mechanics mechanics_;
  std::vector<std::size_t> left_;  // left segment of each contact; equal to right_ if it is seized
  std::vector<std::size_t> right_;
  std::vector<std::size_t> number_;  // index of each contact within its kind, before a seizure
  // State of Newton's method.
  ExponentStep step_;
  ExponentErrors errors_;
  std::vector<double> wanted_;  // wanted exponents at the last change of the slopes
  std::vector<double> seen_N_;  // … and the larger tensions there
  // State of exponents that go to what their tensions ask for.
  std::vector<double> share_;  // share of the way to its new value that an exponent goes in a step
  std::vector<double> way_;    // way of the last step
  TensionSolver solver_;
  TensionState state_;
  TensionState restored_;
  Mechanics restored_mechanics_;
  bool converged_ = true;
  bool has_motion_ = false;  // true if the state has the motion of this grasp and direction
  bool is_settled_ = false;  // by Newton's method, whose state is that of the last load
};

}  // namespace reeve::causes
