// The residuals of a model, every cause that the model does not have screened against them, and
// fits of the promising ones.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/null_model.hpp"
#include "diagnosis/fit/problem.hpp"
#include "diagnosis/search/candidates.hpp"
#include "numerics/parallel.hpp"

namespace reeve::diagnosis {

// n/2 ln of the ratio of misfits.
double gain_from_misfits(double before, double after, double degrees_of_freedom);

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

class ScreenedCauses {
 public:
  // `problem` must outlive it.
  ScreenedCauses(const Problem& problem, const Model& model,
                 const std::vector<Candidate>& candidates, Workers& workers);
  ScreenedCauses(const ScreenedCauses&) = delete;
  ScreenedCauses& operator=(const ScreenedCauses&) = delete;

  // Those of the candidates that the model does not have.
  const std::vector<Candidate>& candidates() const { return candidates_; }
  const Forecast& at() const { return at_; }
  const Projection& projection() const { return projection_; }
  const Screening& screening() const { return screening_; }
  const Eigen::VectorXd& residuals() const { return residuals_; }

  enum class Laws { by_gain, always };
  // Indices of the candidates with the greatest gains, at most so many. Far from nominal a law is
  // no straight line, and what the screening says of it is too little: `Laws::always` adds the laws
  // of friction, whatever their gain. What is there or not is no line at all, and may have drawn
  // the coefficients so far that it seems to gain nothing beside them: the few that leave the least
  // beside the hardware's own coefficients are among them, too.
  std::vector<std::size_t> contenders(std::size_t most, Laws laws) const;

  // Each of these candidates fitted together with the model's effects; parallel to `which`. What is
  // there or not is fitted from the hardware's coefficients, too.
  std::vector<Fit> fit_each(const std::vector<std::size_t>& which) const;

 private:
  std::vector<std::size_t> likeliest_without_size() const;

  const Problem& problem_;
  const Model& model_;
  Workers& workers_;
  std::vector<Candidate> candidates_;
  Forecast at_;
  Projection projection_;
  Eigen::VectorXd residuals_;
  Screening screening_;
};

// The fit that explains most for its parameters (G. Schwarz, Ann. Stat. 6, 1978): a law with a
// shape bends to whatever stands beside it. 0 if there are none.
std::size_t likeliest(const Problem& problem, const std::vector<Fit>& fits);

}  // namespace reeve::diagnosis
