// 95 % intervals of a model's fitted parameters, to first order about the fit.
//
// e are the residuals and J the sensitivities in units of the noise, e_r and J_r the rows of run r,
// H = JᵀJ, H_r = J_rᵀJ_r. Two things may move the fit, and the one that moves it more counts:
//
//   known scatter         var = s² H⁻¹, s² = |e|² / ν but at least 1; Student's t for ν degrees.
//                         Of a share f of the variance that comes from what mountings share
//                         (mounting_scatter.hpp), known from m differences, degrees as of a sum of
//                         variances: 1 / ((1 − f)² / ν + f² / m) (F. E. Satterthwaite, Biometrics
//                         Bulletin 2, 1946); assumed scatter is taken as known
//   scatter between runs  run r moves the fit by δ_r = H⁻¹ J_rᵀ e_r:
//                         var_j = R/(R−1) Σ_r δ_rj², Student's t for R−1 degrees, where
//                         R = (Σ_r h_r)² / Σ_r h_r², h_r = (H⁻¹ H_r H⁻¹)_jj, is how many runs tell
//                         of the parameter j (K.-Y. Liang and S. L. Zeger, Biometrika 73, 1986;
//                         R. M. Bell and D. F. McCaffrey, Survey Methodology 28, 2002)
//
// Where fewer than four runs tell of a parameter, its own scatter between runs cannot be known. It
// is then taken to scatter as all parameters together do: var = b² H⁻¹ with
// b² = Σ_r |Q_r e_r|² / (Σ_r rank Q_r − p), Q_r the projection onto run r's sensitivities, p the
// number of parameters. With fewer than four runs in all, or too little left for b, only
// independent readings are known. A parameter that moves no reading to first order, such as the
// place of a step, goes as far as the misfit rises by the square of t. An interval lies within the
// range of its parameter.
#pragma once

#include <limits>
#include <vector>

#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

struct ParameterInterval {
  double low = 0;
  double high = 0;
  double deviation = 0;  // standard error; infinite where no slope tells it
  double degrees = 1;    // degrees of freedom of Student's t for the half-width
};

// Parallel to the effects and their parameters.
// `mounting_degrees` is m; infinite if the scatter of mountings is known.
std::vector<std::vector<ParameterInterval>> parameter_intervals(
    const Problem& problem, const Model& model,
    double mounting_degrees = std::numeric_limits<double>::infinity());

}  // namespace reeve::diagnosis
