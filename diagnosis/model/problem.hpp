// A dataset with its noise: residuals in units of their standard deviation, and how they follow
// the parameters of a model.
//
//   e_i = (T_i − m_i) / sd_i,    J_ij = dm_i/dθ_j / sd_i
//   m_i = p_i Φ(p_i / sd_i) + sd_i φ(p_i / sd_i)
//
// m is what a sensor reads on average that should read p and cannot read less than 0: where p is
// more than some sd, p itself.
//
// Where a row has no motor tension its scale is free, and what a change of scale could explain is
// taken out of both.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "causes/model.hpp"
#include "diagnosis/data/dataset.hpp"
#include "diagnosis/model/forecast.hpp"

namespace reeve::diagnosis {

struct Problem {
  const Dataset* dataset = nullptr;  // must outlive the problem
  Eigen::VectorXd measured_N;
  Eigen::VectorXd deviation_N;
};

Problem problem(const Dataset& dataset, const Eigen::VectorXd& deviation_N);

// m of each cell, N.
Eigen::VectorXd expected_readings(const Problem& problem, const Forecast& forecast);

// Takes what a change of the rows' free scales could explain out of a vector in units of the noise.
void take_out_scales(const Problem& problem, const Forecast& at, Eigen::VectorXd& whitened);

Eigen::VectorXd residuals(const Problem& problem, const Forecast& forecast);

// N², of each cell: of the residuals, in newton, that nothing but noise leaves.
Eigen::VectorXd noise_variance(const Problem& problem, const Forecast& at);

// Σ e²; infinite where the model has no tensions.
double misfit(const Problem& problem, const Model& model);

// A difference of forecasts, seen from `at`, in units of the noise.
Eigen::VectorXd difference(const Problem& problem, const Forecast& at, const Forecast& other);

// One column for each parameter of the effect at this place of the model; 0 where the model has no
// tensions beside it.
Eigen::MatrixXd sensitivity(const Problem& problem, const Model& model, const Forecast& at,
                            std::size_t effect);
// Of all effects side by side.
Eigen::MatrixXd sensitivities(const Problem& problem, const Model& model, const Forecast& at);

std::size_t parameter_count(const Model& model);

}  // namespace reeve::diagnosis
