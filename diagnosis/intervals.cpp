#include "diagnosis/intervals.hpp"

#include <Eigen/Cholesky>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include "numerics/random.hpp"

namespace reeve {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t draws = 1000;
constexpr std::size_t enough_runs = 4;
constexpr std::uint32_t stream = 0xb007;
constexpr double covered = 0.95;

struct NormalEquations {
  MatrixXd square;
  VectorXd along;
};

std::vector<NormalEquations> by_run(const Problem& problem, const MatrixXd& jacobian,
                                    const VectorXd& residuals) {
  std::map<std::size_t, NormalEquations> runs;
  const Dataset& dataset = *problem.dataset;
  for (const DatasetRow& row : dataset.rows) {
    const auto first = static_cast<Index>(row.first);
    const auto size = static_cast<Index>(row.last - row.first);
    const auto part = jacobian.middleRows(first, size);
    NormalEquations& run = runs[dataset.data->readings[row.reading].run];
    if (run.along.size() == 0) {
      run = {MatrixXd::Zero(jacobian.cols(), jacobian.cols()), VectorXd::Zero(jacobian.cols())};
    }
    run.square += part.transpose() * part;
    run.along += part.transpose() * residuals.segment(first, size);
  }
  std::vector<NormalEquations> result;
  for (auto& [run, equations] : runs) result.push_back(std::move(equations));
  return result;
}

VectorXd step(const NormalEquations& equations) {
  // A sample may miss what a parameter shows in; a trace of damping keeps it where it was.
  const MatrixXd damped =
      equations.square + 1e-9 * MatrixXd(equations.square.diagonal().asDiagonal());
  return damped.ldlt().solve(equations.along);
}

// Of the samples, about the fit.
VectorXd resampled_deviation(const std::vector<NormalEquations>& runs, std::uint64_t seed) {
  const Index parameters = runs.front().along.size();
  VectorXd squares = VectorXd::Zero(parameters);
  VectorXd sum = VectorXd::Zero(parameters);
  for (std::size_t d = 0; d < draws; ++d) {
    NormalEquations drawn{MatrixXd::Zero(parameters, parameters), VectorXd::Zero(parameters)};
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const double u = uniform(seed, stream, d * runs.size() + i);
      const NormalEquations& run =
          runs[static_cast<std::size_t>(u * static_cast<double>(runs.size()))];
      drawn.square += run.square;
      drawn.along += run.along;
    }
    const VectorXd moved = step(drawn);
    if (!moved.allFinite()) continue;
    sum += moved;
    squares += moved.cwiseAbs2();
  }
  const auto n = static_cast<double>(draws);
  const auto r = static_cast<double>(runs.size());
  const VectorXd variance = (squares / n - (sum / n).cwiseAbs2()).cwiseMax(0.0);
  return (variance * (r / (r - 1))).cwiseSqrt();
}

double t_quantile(double degrees) {
  return boost::math::quantile(boost::math::students_t(std::max(degrees, 1.0)), 0.5 + covered / 2);
}

}  // namespace

std::vector<std::vector<ParameterInterval>> parameter_intervals(const Problem& problem,
                                                                const Model& model,
                                                                std::uint64_t seed) {
  const Forecast at = forecast(*problem.dataset, model);
  const MatrixXd jacobian = sensitivities(problem, model, at);
  std::vector<std::vector<ParameterInterval>> result(model.effects.size());
  if (jacobian.cols() == 0) return result;
  const VectorXd left = residuals(problem, at);
  const std::vector<NormalEquations> runs = by_run(problem, jacobian, left);
  const double degrees =
      std::max(1.0, problem.dataset->degrees_of_freedom() - static_cast<double>(jacobian.cols()));
  const double spread = std::max(1.0, left.squaredNorm() / degrees);
  const MatrixXd covariance =
      spread * MatrixXd(jacobian.transpose() * jacobian)
                   .ldlt()
                   .solve(MatrixXd::Identity(jacobian.cols(), jacobian.cols()));
  VectorXd half = t_quantile(degrees) * covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  if (runs.size() >= enough_runs) {
    const double wide = t_quantile(static_cast<double>(runs.size()) - 1);
    half = half.cwiseMax(wide * resampled_deviation(runs, seed));
  }
  Index column = 0;
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    const Effect& effect = model.effects[e];
    const auto parameters = effect.cause->parameters(model.hardware);
    for (std::size_t p = 0; p < parameters.size(); ++p, ++column) {
      const Range range = parameters[p].range;
      const double reach = std::isfinite(half[column]) ? half[column] : range.high - range.low;
      result[e].push_back({std::max(range.low, effect.values[p] - reach),
                           std::min(range.high, effect.values[p] + reach)});
    }
  }
  return result;
}

}  // namespace reeve
