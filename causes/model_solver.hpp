// Tensions of a routing under a model whose exponents may depend on the conditions and on the
// tensions themselves.
//
// The exponents of the plain model are changed by each effect in turn, phi' = f(phi, T_high); where
// one depends on the tension, tensions and exponents are solved in turn until the exponents no
// longer change (to 1e-10, relative). Behind a motor-side segment a contact's exponent depends on
// those before it only, so that this ends after about as many rounds as there are contacts in a
// row; if it does not, steps are halved.
#pragma once

#include <string>
#include <vector>

#include "causes/model.hpp"
#include "core/mechanics.hpp"
#include "core/seizure.hpp"
#include "core/tension.hpp"

namespace reeve {

// One routing under one model, in any grasp and under any conditions. Keeps its memory.
class ModelSolver {
 public:
  // `model` is kept by reference; `word` says which routing the effects on routings mean.
  // `hardware` is the effective one (a row's own sheath angle is in it already).
  ModelSolver(const Model& model, const Hardware& hardware, const std::string& word,
              const Network& network);

  // At T_M = 1, in the order of the network's segments. `grasp` is the real one.
  const TensionState& solve(Grasp grasp, Direction direction, const Conditions& conditions);

  // Whether the last solve converged.
  bool converged() const { return converged_; }

 private:
  double change_exponents(const Conditions& conditions, double share);
  double exponent(std::size_t contact, double high_N, const Conditions& conditions) const;

  std::vector<const Effect*> exponent_effects_;
  bool depends_on_load_ = false;
  SeizedNetwork seized_;
  Mechanics plain_;
  Mechanics mechanics_;
  std::vector<std::size_t> left_;  // of each contact; equal to right_ if it is seized
  std::vector<std::size_t> right_;
  TensionSolver solver_;
  TensionState state_;
  TensionState restored_;
  bool converged_ = true;
};

}  // namespace reeve
