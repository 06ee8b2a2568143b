#include "diagnosis/model/intervals.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "diagnosis/model/run_equations.hpp"
#include "numerics/student_t.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// With fewer Student's t is wider than what the readings' own noise could ever excuse: at 3 degrees
// of freedom it is 3.2 standard deviations, at 2 it is 4.3 and at 1 it is 12.7.
constexpr double enough_telling_runs = 4;
constexpr double enough_shared_degrees = 3;
constexpr double covered = 0.95;
double two_sided_t(double degrees) { return student_t_quantile(0.5 + covered / 2, degrees); }

// b² and its degrees of freedom; none left: 0.
struct SharedScatter {
  double square = 0;
  double degrees = 0;
};

SharedScatter shared_scatter(const std::vector<RunEquations>& runs, const VectorXd& scale) {
  SharedScatter shared;
  // Of many runs each has a small share in what all know.
  const double least = std::min(least_share, 0.1 / static_cast<double>(runs.size()));
  for (const RunEquations& run : runs) {
    const MatrixXd scaled = scale.asDiagonal() * run.square * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(scaled);
    const VectorXd along = axes.eigenvectors().transpose() * (scale.asDiagonal() * run.along);
    for (Index i = 0; i < along.size(); ++i) {
      if (axes.eigenvalues()[i] < least) continue;
      shared.square += along[i] * along[i] / axes.eigenvalues()[i];
      shared.degrees += 1;
    }
  }
  shared.degrees -= static_cast<double>(scale.size());
  shared.square = shared.degrees > 0 ? shared.square / shared.degrees : 0;
  return shared;
}

class HalfWidths {
 public:
  HalfWidths(std::vector<RunEquations> runs, const MatrixXd& jacobian, const VectorXd& residuals,
             double degrees)
      : runs_(std::move(runs)),
        inverse_(MatrixXd(jacobian.transpose() * jacobian)
                     .ldlt()
                     .solve(MatrixXd::Identity(jacobian.cols(), jacobian.cols()))),
        shared_(shared_scatter(runs_, column_scale(jacobian))),
        reading_spread_(std::max(1.0, residuals.squaredNorm() / degrees)),
        degrees_(degrees) {}

  // Infinite where no reading depends on the parameter.
  double operator()(Index parameter) const {
    const double half = std::max(of_readings(parameter), of_runs(parameter));
    return half > 0 ? half : std::numeric_limits<double>::infinity();
  }

 private:
  double known(Index parameter) const { return std::max(0.0, inverse_(parameter, parameter)); }

  double of_readings(Index parameter) const {
    return two_sided_t(degrees_) * std::sqrt(reading_spread_ * known(parameter));
  }

  double of_runs(Index parameter) const {
    if (static_cast<double>(runs_.size()) < enough_telling_runs) return 0;
    double told = 0;
    double told_squares = 0;
    double moved_squares = 0;
    for (const RunEquations& run : runs_) {
      const double h = inverse_.row(parameter).dot(run.square * inverse_.col(parameter));
      told += h;
      told_squares += h * h;
      moved_squares += std::pow(inverse_.row(parameter).dot(run.along), 2);
    }
    const double telling = told_squares > 0 ? told * told / told_squares : 0;
    if (telling >= enough_telling_runs) {
      return two_sided_t(telling - 1) * std::sqrt(telling / (telling - 1) * moved_squares);
    }
    if (shared_.degrees < enough_shared_degrees) return 0;
    return two_sided_t(shared_.degrees) * std::sqrt(shared_.square * known(parameter));
  }

  std::vector<RunEquations> runs_;
  MatrixXd inverse_;  // H⁻¹
  SharedScatter shared_;
  double reading_spread_;
  double degrees_;
};

}  // namespace

std::vector<std::vector<ParameterInterval>> parameter_intervals(const Problem& problem,
                                                                const Model& model) {
  const Forecast at = forecast(*problem.dataset, model);
  const MatrixXd jacobian = sensitivities(problem, model, at);
  std::vector<std::vector<ParameterInterval>> result(model.effects.size());
  if (jacobian.cols() == 0) return result;
  const VectorXd left = residuals(problem, at);
  const double degrees =
      std::max(1.0, problem.dataset->degrees_of_freedom() - static_cast<double>(jacobian.cols()));
  const HalfWidths half(run_equations(problem, jacobian, left), jacobian, left, degrees);
  Index column = 0;
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    const Effect& effect = model.effects[e];
    const auto parameters = effect.cause->parameters(model.hardware);
    for (std::size_t p = 0; p < parameters.size(); ++p, ++column) {
      const Range range = parameters[p].range;
      const double width = half(column);
      const double reach = std::isfinite(width) ? width : range.high - range.low;
      result[e].push_back({std::max(range.low, effect.values[p] - reach),
                           std::min(range.high, effect.values[p] + reach)});
    }
  }
  return result;
}

}  // namespace reeve::diagnosis
