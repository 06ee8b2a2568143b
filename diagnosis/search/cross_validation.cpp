#include "diagnosis/search/cross_validation.hpp"

#include <Eigen/Eigenvalues>

#include <optional>
#include <vector>

#include "diagnosis/model/run_equations.hpp"

namespace reeve {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Σ of the squared residuals of each run, forecast from the others; nothing where they cannot.
class LeftOut {
 public:
  LeftOut(const Problem& problem, const Model& model) {
    const Forecast at = forecast(*problem.dataset, model);
    jacobian_ = sensitivities(problem, model, at);
    jacobian_ *= column_scale(jacobian_).asDiagonal();
    residuals_ = residuals(problem, at);
    for (const RunEquations& run : run_equations(problem, jacobian_, residuals_)) {
      misfits_.push_back(misfit(run));
    }
  }

  const std::vector<std::optional<double>>& misfits() const { return misfits_; }

 private:
  std::optional<double> misfit(const RunEquations& run) const {
    VectorXd left(static_cast<Eigen::Index>(run.cells.size()));
    for (Eigen::Index i = 0; i < left.size(); ++i) {
      left[i] = residuals_[run.cells[static_cast<std::size_t>(i)]];
    }
    if (jacobian_.cols() == 0) return left.squaredNorm();
    const MatrixXd others = jacobian_.transpose() * jacobian_ - run.square;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(others);
    const VectorXd& known = axes.eigenvalues();
    const MatrixXd& directions = axes.eigenvectors();
    for (Eigen::Index k = 0; k < known.size(); ++k) {
      const double told = directions.col(k).dot(run.square * directions.col(k));
      if (known[k] < least_share && told >= least_share) return std::nullopt;
    }
    const VectorXd moved =
        directions *
        (directions.transpose() * run.along).cwiseQuotient(known.cwiseMax(least_share));
    for (Eigen::Index i = 0; i < left.size(); ++i) {
      left[i] += jacobian_.row(run.cells[static_cast<std::size_t>(i)]).dot(moved);
    }
    return left.squaredNorm();
  }

  MatrixXd jacobian_;
  VectorXd residuals_;
  std::vector<std::optional<double>> misfits_;
};

}  // namespace

double left_out_gain(const Problem& problem, const Model& before, const Model& after) {
  const LeftOut first(problem, before);
  const LeftOut second(problem, after);
  double gain = 0;
  for (std::size_t r = 0; r < first.misfits().size(); ++r) {
    if (!first.misfits()[r] || !second.misfits()[r]) continue;
    gain += (*first.misfits()[r] - *second.misfits()[r]) / 2;
  }
  return gain;
}

}  // namespace reeve
