// Whether the runs that a model was fitted to confirm each other: each is forecast from the others.
//
// With run r left out the parameters move by −(H − H_r)⁻¹ g_r, to first order about the fit
// (run_equations.hpp), so that its residuals become
//
//   e_r + J_r (H − H_r)⁻¹ g_r        (PRESS; D. M. Allen, Technometrics 16, 1974, by runs)
//
// A run that alone knows some parameter cannot be forecast by the others, and is passed over.
#pragma once

#include <optional>
#include <vector>

#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

// Σ of the squared residuals of each run, forecast from the others by a model that is fitted to the
// problem; nothing where they cannot forecast it. In the order of run_equations.
using LeftOutMisfits = std::vector<std::optional<double>>;
LeftOutMisfits left_out_misfits(const Problem& problem, const Model& model);

// By how much `after` forecasts the runs better than `before`, in log-likelihood. 0 where there is
// no run to judge by.
double left_out_gain(const LeftOutMisfits& before, const LeftOutMisfits& after);

}  // namespace reeve::diagnosis
