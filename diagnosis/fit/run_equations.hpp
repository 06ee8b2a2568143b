// What each run says of a model's parameters, to first order about a fit: H_r = J_rᵀ J_r and
// g_r = J_rᵀ e_r, with the rows of the residuals e and sensitivities J that belong to run r, in
// units of the noise.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

// A run with a smaller share of what is known of a direction says nothing about it: sensitivities
// are differences of forecasts, and what rounding leaves of them is no knowledge.
inline constexpr double least_share = 1e-3;

struct RunEquations {
  std::vector<Eigen::Index> cells;
  Eigen::MatrixXd square;  // H_r
  Eigen::VectorXd along;   // g_r
};

// In the order in which the data name the runs.
std::vector<RunEquations> run_equations(const Problem& problem, const Eigen::MatrixXd& jacobian,
                                        const Eigen::VectorXd& residuals);

// One over the length of each column, so that parameters of any unit compare; 1 for a column of
// zeros.
Eigen::VectorXd column_scale(const Eigen::MatrixXd& jacobian);

}  // namespace reeve::diagnosis
