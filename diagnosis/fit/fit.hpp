// Fitting the parameters of a model's effects to a problem by least squares (least_squares.hpp,
// from several starts; NLopt's BOBYQA where that gets stuck, as at the kinks between kinds of
// grasps): the most likely values under normal noise of the problem's standard deviations.
#pragma once

#include <vector>

#include "diagnosis/fit/problem.hpp"
#include "numerics/least_squares.hpp"

namespace reeve::diagnosis {

using numerics::Precision;

struct Fit {
  Model model;
  double misfit = 0;  // Σ e²
};

// True if the fitted model has tensions at all; otherwise its misfit is infinite.
bool has_tensions(const Fit& fit);

// From the model's own values.
Fit fit(const Problem& problem, const Model& model, Precision precision = Precision::full);

// With the effect at this place started from each of `starts` (and from values across its range),
// the best two of which are refined; the others start where they are.
Fit fit(const Problem& problem, const Model& model, std::size_t effect,
        const std::vector<std::vector<double>>& starts, Precision precision = Precision::full);

bool same_effect(const Effect& a, const Effect& b);

// Returns the index of the effect in the model, whatever its size.
std::size_t place(const Model& model, const Effect& effect);

// Adds an effect to a copy and says where it went.
struct Extended {
  Model model;
  std::size_t effect = 0;
};
Extended extended(const Model& model, const Effect& effect);
Model without(Model model, std::size_t effect);

}  // namespace reeve::diagnosis
