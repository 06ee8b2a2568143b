// Whether the runs that a model was fitted to confirm each other: each is forecast from the others.
//
// With run r left out the parameters move by −(H − H_r)⁻¹ g_r, to first order about the fit
// (run_equations.hpp), so that its residuals become
//
//   e_r + J_r (H − H_r)⁻¹ g_r        (PRESS; D. M. Allen, Technometrics 16, 1974, by runs)
//
// A run that alone knows some parameter cannot be forecast by the others, and is passed over.
#pragma once

#include "diagnosis/model/problem.hpp"

namespace reeve {

// By how much `after` forecasts the runs better than `before`, each run from the others, in
// log-likelihood; both are fitted to the problem. 0 where there is no run to judge by.
double left_out_gain(const Problem& problem, const Model& before, const Model& after);

}  // namespace reeve
