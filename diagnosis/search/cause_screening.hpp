// Every cause of the library screened to first order against what a model leaves.
//
// A cause with a size changes the forecasts along its sensitivity q (whitened, parameters of the
// model projected out); the residuals e give it
//
//   size = q·e / |q|²,   gain in log-likelihood = (q·e)² / 2|q|²
//
// if that size has a sign that the cause can have. A cause without size changes them by d as a
// whole: gain = d·e − |d|²/2. Gains are then taken at the noise that the residuals themselves
// show: G = (ν/2) ln(|e|² / (|e|² − 2 gain)), with ν degrees of freedom.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/null_model.hpp"
#include "diagnosis/search/candidates.hpp"
#include "numerics/parallel.hpp"

namespace reeve::diagnosis {

// n/2 ln of the ratio of misfits; 0 if the misfit does not fall.
double gain_from_misfits(double before, double after, double degrees_of_freedom);

struct ScreenedCause {
  std::size_t candidate = 0;
  double gain = 0;
  std::vector<std::vector<double>> starts;  // for a fit: the first-order size, for each shape
};

class CauseScreening {
 public:
  // Columns of all readings; parts of them are screened by these, too. The dataset must outlive it.
  CauseScreening(const Dataset& dataset, const Model& model, const Forecast& at,
                 const std::vector<Effect>& candidates, Workers& workers);

  // Returns the causes that gain, the greatest gain first. The problem covers some of the readings.
  std::vector<ScreenedCause> run(const Problem& problem, const Forecast& at,
                                 const Projection& projection,
                                 const Eigen::VectorXd& residuals) const;

 private:
  // A column of the matrix: one candidate with one shape.
  struct Probe {
    std::size_t candidate = 0;
    std::vector<double> values;
    Range size;

    bool has_size() const { return !values.empty(); }
    double raw_gain(double along, double square) const;
    void add_starts(double first_order, ScreenedCause& to) const;
  };

  const Dataset& all_;
  std::vector<Probe> probes_;
  Eigen::MatrixXd columns_N_;
};

}  // namespace reeve::diagnosis
