// A dataset with its noise: residuals in units of their standard deviation, and how they follow
// the parameters of a model.
//
//   e_i = (T_i − m_i) / sd_i,    J_ij = dm_i/dθ_j / sd_i
//   m_i = p_i Φ(p_i / sd_i) + sd_i φ(p_i / sd_i)     of a channel that never reads below 0
//   m_i = p_i                                        of one that does: a load cell that drifts
//
// m is what a sensor reads on average that should read p and cannot read less than 0: where p is
// more than some sd, p itself.
//
// Where a row has no motor tension its scale is free, and what a change of scale could explain is
// taken out of both. Where its motor tension is known to scatter, by s_M, the row's readings share
// the part s_M dm/dT_M of their scatter; with s = s_M dm/dT_M / sd they have the covariance
// 1 + s sᵀ, and
//
//   (1 + s sᵀ)^{-1/2} = 1 − (1 − (1 + sᵀs)^{-1/2}) s sᵀ / sᵀs
//
// leaves them independent. Since s follows from the model, the least sum of squares is that over
// all true motor tensions, too: errors in variables, not a regression on what was read, which would
// find gains below 1 (W. E. Deming, Statistical Adjustment of Data, 1943). Where readings of a
// mounting share a part of their scatter, both are made independent (whitening.hpp); residuals in
// units of their own noise alone are `own_residuals`.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "causes/model.hpp"
#include "diagnosis/dataset.hpp"
#include "diagnosis/fit/forecast.hpp"
#include "diagnosis/fit/mounting.hpp"
#include "diagnosis/fit/whitening.hpp"

namespace reeve::diagnosis {

struct Problem {
  const Dataset* dataset = nullptr;  // must outlive the problem
  Eigen::VectorXd measured_N;
  Eigen::VectorXd deviation_N;  // noise of each reading by itself
  // Standard deviation of each row's motor tension; empty if all are exact.
  Eigen::VectorXd motor_deviation_N;
  std::vector<bool> clips;  // parallel to the cells: cannot read below 0
  Whitening shared;         // none: readings scatter independently
  double force_scale = 1;   // scale of ranges in newton
};

// The cause's parameters with ranges that go with the loads of the data.
std::vector<Parameter> searched_parameters(const Cause& cause, const Hardware& hardware,
                                           double force_scale);

Problem problem(const Dataset& dataset, const Eigen::VectorXd& deviation_N);

// Sets the motor tensions' standard deviations at their estimated true values, from their own
// reading and the others of the row. At the readings themselves, readings that chance made small
// would weigh more than those that it made large.
void settle_motor_deviations(Problem& problem, const Forecast& at);

// Readings of a mounting share what these things do that scatter so much.
void share_scatter(Problem& problem, const MountingModes& modes, const MountedScatter& scatter,
                   const Forecast& at);

// The same problem of some of its mountings: of each, `dataset` has all readings or none.
Problem part_of(const Problem& whole, const Dataset& dataset);

// The forecasts with what the problem's residuals depend on: slopes where motor tensions scatter.
std::optional<Forecast> try_forecast(const Problem& problem, const Model& model);

// m of each cell, N.
Eigen::VectorXd expected_readings(const Problem& problem, const Forecast& forecast);

// Takes what a change of the rows' free scales could explain out of columns in units of the noise,
// and of scales that scatter their part.
void take_out_scales(const Problem& problem, const Forecast& at,
                     Eigen::Ref<Eigen::MatrixXd> whitened);

Eigen::VectorXd residuals(const Problem& problem, const Forecast& forecast);
Eigen::VectorXd own_residuals(const Problem& problem, const Forecast& forecast);
// N, as anybody reads them off the file: nothing that scatters is taken out.
Eigen::VectorXd newton_residuals(const Problem& problem, const Forecast& forecast);

// N², of each cell: of its residual in newton, if that is scatter alone.
Eigen::VectorXd noise_variance(const Problem& problem, const Forecast& at);

// N, of each cell: of its reading, with what it shares with its mounting.
Eigen::VectorXd total_deviations(const Problem& problem);

// Σ e²; infinite where the model has no tensions.
double misfit(const Problem& problem, const Model& model);

// Returns ln det of the covariance of the readings, in N², without the free or scattering scales of
// their rows.
double log_determinant(const Problem& problem);

// A difference of forecasts, seen from `at`, in units of the noise.
Eigen::VectorXd difference(const Problem& problem, const Forecast& at, const Forecast& other);

// One column for each parameter of the effect at this place of the model; 0 where the model has no
// tensions beside it.
Eigen::MatrixXd sensitivity(const Problem& problem, const Model& model, const Forecast& at,
                            std::size_t effect);
// Returns the sensitivities of all effects side by side.
Eigen::MatrixXd sensitivities(const Problem& problem, const Model& model, const Forecast& at);

std::size_t parameter_count(const Model& model);

}  // namespace reeve::diagnosis
