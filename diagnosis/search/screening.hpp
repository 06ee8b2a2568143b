// How much each cause could explain of what the current model leaves, to first order.
//
// A cause with a size changes the forecasts along its sensitivity q (parameters of the model
// projected out); the residuals e give it
//
//   size = q·e / |q|²,   gain in log-likelihood = (q·e)² / 2|q|²
//
// if that size has a sign that the cause can have. A cause without size changes them by d as a
// whole: gain = d·e − |d|²/2. Gains are then taken at the noise that the residuals themselves
// show: G = (ν/2) ln(|e|² / (|e|² − 2 gain)), with ν degrees of freedom.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "diagnosis/fit/null_model.hpp"
#include "diagnosis/fit/problem.hpp"
#include "diagnosis/search/candidates.hpp"
#include "numerics/parallel.hpp"

namespace reeve::diagnosis {

// n/2 ln of the ratio of misfits.
double gain_from_misfits(double before, double after, double degrees_of_freedom);

class Screening {
 public:
  Screening(const Problem& problem, const Model& model, const Forecast& at,
            const Projection& projection, const std::vector<Candidate>& candidates,
            Workers& workers);

  // Parallel to the candidates; not below 0.
  std::vector<double> gains(const Eigen::VectorXd& residuals) const;
  double greatest_gain(const Eigen::VectorXd& residuals) const;
  // Of each column.
  std::vector<double> greatest_gains(const Eigen::MatrixXd& residuals) const;

  // Where a fit of each candidate should start: the size of the first order, for each shape.
  std::vector<std::vector<double>> starts(std::size_t candidate,
                                          const Eigen::VectorXd& residuals) const;

 private:
  // A column of the matrix: one candidate with one shape.
  struct Probe {
    std::size_t candidate = 0;
    std::vector<double> values;
    bool has_size = true;
    double nominal = 0;
    Range range;
  };

  double raw_gain(std::size_t probe, double along) const;
  // By what the residuals have along each probe, and their sum of squares.
  std::vector<double> gains_along(const Eigen::VectorXd& along, double before) const;

  const std::vector<Candidate>& candidates_;
  std::vector<Probe> probes_;
  Eigen::MatrixXd columns_;
  Eigen::VectorXd squares_;
  double degrees_;
};

}  // namespace reeve::diagnosis
