#include "diagnosis/search/cross_validation.hpp"

#include "diagnosis/fit/run_equations.hpp"
#include "numerics/matrices.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

class LeftOut {
 public:
  LeftOut(const Problem& problem, const Model& model) {
    const Forecast at = forecast(*problem.dataset, model);
    jacobian_ = sensitivities(problem, model, at);
    jacobian_ *= column_scale(jacobian_).asDiagonal();
    square_ = jacobian_.transpose() * jacobian_;
    residuals_ = residuals(problem, at);
    runs_ = run_equations(problem, jacobian_, residuals_);
  }

  LeftOutMisfits misfits() const {
    LeftOutMisfits result;
    for (const RunEquations& run : runs_) result.push_back(misfit(run));
    return result;
  }

 private:
  std::optional<double> misfit(const RunEquations& run) const {
    VectorXd left(static_cast<Eigen::Index>(run.cells.size()));
    for (Eigen::Index i = 0; i < left.size(); ++i) {
      left[i] = residuals_[run.cells[static_cast<std::size_t>(i)]];
    }
    if (jacobian_.cols() == 0) return left.squaredNorm();
    const auto [known, directions] = symmetric_axes(square_ - run.square);
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
  MatrixXd square_;  // JᵀJ
  VectorXd residuals_;
  std::vector<RunEquations> runs_;
};

}  // namespace

LeftOutMisfits left_out_misfits(const Problem& problem, const Model& model) {
  return LeftOut(problem, model).misfits();
}

double left_out_gain(const LeftOutMisfits& before, const LeftOutMisfits& after) {
  double gain = 0;
  for (std::size_t r = 0; r < before.size(); ++r) {
    if (before[r] && after[r]) gain += (*before[r] - *after[r]) / 2;
  }
  return gain;
}

}  // namespace reeve::diagnosis
