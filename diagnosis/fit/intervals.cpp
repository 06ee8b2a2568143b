#include "diagnosis/fit/intervals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "numerics/matrices.hpp"
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

MatrixXd inverse_square(const MatrixXd& jacobian) {
  return inverse_of_symmetric(jacobian.transpose() * jacobian);
}

// The equations of one run for a model's parameters, to first order about a fit: H_r = J_rᵀ J_r and
// g_r = J_rᵀ e_r, with the rows of the residuals e and sensitivities J that belong to run r, in
// units of the noise.
struct RunEquations {
  std::vector<Index> cells;
  MatrixXd square;  // H_r
  VectorXd along;   // g_r
};

// A run with a smaller share of what is known of a direction says nothing about it: sensitivities
// are differences of forecasts, and what rounding leaves of them is no knowledge.
constexpr double least_share = 1e-3;

// The runs stand in the order in which the data name them.
std::vector<RunEquations> run_equations(const Problem& problem, const MatrixXd& jacobian,
                                        const VectorXd& residuals) {
  std::map<std::size_t, RunEquations> runs;
  const Dataset& dataset = *problem.dataset;
  const Index parameters = jacobian.cols();
  for (const DatasetRow& row : dataset.rows) {
    const auto first = static_cast<Index>(row.first);
    const auto size = static_cast<Index>(row.last - row.first);
    const auto part = jacobian.middleRows(first, size);
    RunEquations& run = runs[dataset.data->readings[row.reading].run];
    if (run.cells.empty()) {
      run.square.setZero(parameters, parameters);
      run.along.setZero(parameters);
    }
    for (Index i = 0; i < size; ++i) run.cells.push_back(first + i);
    run.square += part.transpose() * part;
    run.along += part.transpose() * residuals.segment(first, size);
  }
  std::vector<RunEquations> result;
  for (auto& [run, equations] : runs) result.push_back(std::move(equations));
  return result;
}

// One over the length of each column, so that parameters of any unit compare; 1 for a column of
// zeros.
VectorXd column_scale(const MatrixXd& jacobian) {
  const VectorXd lengths = jacobian.colwise().norm().transpose();
  return lengths.unaryExpr([](double length) { return length > 0 ? 1 / length : 1.0; });
}

// The variances of the parameters that readings would leave which share nothing.
VectorXd own_variance(Problem problem, const Model& model, const Forecast& at) {
  problem.shared.clear();
  return inverse_square(sensitivities(problem, model, at)).diagonal();
}

struct Spread {
  double deviation = 0;
  double degrees = 1;

  double half_width() const { return two_sided_t(degrees) * deviation; }
};

// b² and its degrees of freedom; none left: 0.
struct ScatterOfAll {
  double square = 0;
  double degrees = 0;
};

ScatterOfAll scatter_of_all(const std::vector<RunEquations>& runs, const VectorXd& scale) {
  ScatterOfAll shared;
  // The more runs there are, the smaller is the share of each in the common estimate.
  const double least = std::min(least_share, 0.1 / static_cast<double>(runs.size()));
  for (const RunEquations& run : runs) {
    const MatrixXd scaled = scale.asDiagonal() * run.square * scale.asDiagonal();
    const SymmetricAxes axes = symmetric_axes(scaled);
    const VectorXd along = axes.vectors.transpose() * (scale.asDiagonal() * run.along);
    for (Index i = 0; i < along.size(); ++i) {
      if (axes.values[i] < least) continue;
      shared.square += along[i] * along[i] / axes.values[i];
      shared.degrees += 1;
    }
  }
  shared.degrees -= static_cast<double>(scale.size());
  shared.square = shared.degrees > 0 ? shared.square / shared.degrees : 0;
  return shared;
}

class Spreads {
 public:
  Spreads(std::vector<RunEquations> runs, const MatrixXd& jacobian, const VectorXd& residuals,
          double degrees, VectorXd own_variance, double mounting_degrees)
      : runs_(std::move(runs)),
        inverse_(inverse_square(jacobian)),
        shared_(scatter_of_all(runs_, column_scale(jacobian))),
        reading_spread_(std::max(1.0, residuals.squaredNorm() / degrees)),
        degrees_(degrees),
        own_variance_(std::move(own_variance)),
        mounting_degrees_(mounting_degrees) {}

  // Infinite where no reading depends on the parameter.
  Spread operator()(Index parameter) const {
    const Spread known = of_known_scatter(parameter);
    const Spread runs = of_runs(parameter);
    Spread spread = runs.half_width() > known.half_width() ? runs : known;
    if (!(spread.deviation > 0)) spread.deviation = std::numeric_limits<double>::infinity();
    return spread;
  }

 private:
  double known(Index parameter) const { return std::max(0.0, inverse_(parameter, parameter)); }

  Spread of_known_scatter(Index parameter) const {
    const double all = known(parameter);
    // If the readings alone hardly determine the parameter, rounding may give it any variance.
    const double shared = all > 0 ? std::clamp(1 - own_variance_[parameter] / all, 0.0, 1.0) : 0;
    const double degrees =
        1 / ((1 - shared) * (1 - shared) / degrees_ + shared * shared / mounting_degrees_);
    return {std::sqrt(reading_spread_ * all), degrees};
  }

  Spread of_runs(Index parameter) const {
    if (static_cast<double>(runs_.size()) < enough_telling_runs) return {};
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
      return {std::sqrt(telling / (telling - 1) * moved_squares), telling - 1};
    }
    if (shared_.degrees < enough_shared_degrees) return {};
    return {std::sqrt(shared_.square * known(parameter)), shared_.degrees};
  }

  std::vector<RunEquations> runs_;
  MatrixXd inverse_;  // H⁻¹
  ScatterOfAll shared_;
  double reading_spread_;
  double degrees_;
  VectorXd own_variance_;
  double mounting_degrees_;
};

// The place of a step moves no reading until it passes one: no slope tells how far it may go. The
// farthest place towards `end` whose misfit is not greater than `most`.
double farthest_place(const Problem& problem, Model model, std::size_t effect,
                      std::size_t parameter, double end, double most) {
  double& value = model.effects[effect].values[parameter];
  double inside = value;
  const auto fits = [&](double place) {
    value = place;
    return residuals(problem, forecast(*problem.dataset, model)).squaredNorm() <= most;
  };
  if (fits(end)) return end;
  constexpr int halvings = 20;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (inside + end) / 2;
    (fits(middle) ? inside : end) = middle;
  }
  return inside;
}

}  // namespace

std::vector<std::vector<ParameterInterval>> parameter_intervals(const Problem& problem,
                                                                const Model& model,
                                                                double mounting_degrees) {
  const Forecast at = forecast(*problem.dataset, model);
  const MatrixXd jacobian = sensitivities(problem, model, at);
  std::vector<std::vector<ParameterInterval>> result(model.effects.size());
  if (jacobian.cols() == 0) return result;
  const VectorXd left = residuals(problem, at);
  const double degrees =
      std::max(1.0, problem.dataset->degrees_of_freedom() - static_cast<double>(jacobian.cols()));
  const Spreads spreads(run_equations(problem, jacobian, left), jacobian, left, degrees,
                        own_variance(problem, model, at), mounting_degrees);
  const double most_misfit = left.squaredNorm() + std::pow(two_sided_t(degrees), 2) *
                                                      std::max(1.0, left.squaredNorm() / degrees);
  Index column = 0;
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    const Effect& effect = model.effects[e];
    const auto parameters = searched_parameters(*effect.cause, model.hardware, problem.force_scale);
    for (std::size_t p = 0; p < parameters.size(); ++p, ++column) {
      const Range range = parameters[p].range;
      const Spread spread = spreads(column);
      const double width = spread.half_width();
      const double value = effect.values[p];
      ParameterInterval interval{std::max(range.low, value - width),
                                 std::min(range.high, value + width), spread.deviation,
                                 spread.degrees};
      if (!std::isfinite(width)) {
        interval.low = farthest_place(problem, model, e, p, range.low, most_misfit);
        interval.high = farthest_place(problem, model, e, p, range.high, most_misfit);
      }
      result[e].push_back(interval);
    }
  }
  return result;
}

}  // namespace reeve::diagnosis
