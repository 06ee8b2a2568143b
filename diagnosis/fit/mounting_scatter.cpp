#include "diagnosis/fit/mounting_scatter.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <vector>

#include "diagnosis/fit/mounted_comparison.hpp"
#include "numerics/minimise.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// C = I + D^{1/2} A D^{1/2} = P − U Uᵀ, with P in a block for each routing: factored, it costs the
// cube of a routing's mountings and not of all (M. A. Woodbury, Princeton Stat. Res. Group Memo 42,
// 1950).
class Covariance {
 public:
  Covariance(const MountedEquations& equations, const MountedScatter& scatter)
      : tau_(static_cast<Index>(equations.kind.size())) {
    for (Index i = 0; i < tau_.size(); ++i) {
      tau_[i] = scatter[static_cast<std::size_t>(equations.kind[static_cast<std::size_t>(i)])];
    }
    shared_ = tau_.asDiagonal() * equations.shared;
    Index first = 0;
    for (const MatrixXd& square : equations.squares) {
      const auto tau = tau_.segment(first, square.rows());
      MatrixXd block = tau.asDiagonal() * square * tau.asDiagonal();
      block.diagonal().array() += 1;
      blocks_.emplace_back(block);
      first += square.rows();
    }
    solved_ = in_blocks(shared_);
    MatrixXd rest = -shared_.transpose() * solved_;
    rest.diagonal().array() += 1;
    rest_.compute(rest);
  }

  const VectorXd& tau() const { return tau_; }

  double log_determinant() const {
    double half = rest_.matrixLLT().diagonal().array().log().sum();
    for (const auto& block : blocks_) half += block.matrixLLT().diagonal().array().log().sum();
    return 2 * half;
  }

  VectorXd solve(const VectorXd& vector) const {
    const VectorXd known = in_blocks(vector);
    return known + solved_ * rest_.solve(shared_.transpose() * known);
  }

  // Returns the diagonal of C⁻¹.
  VectorXd inverse_diagonal() const {
    VectorXd result(tau_.size());
    Index first = 0;
    for (const auto& block : blocks_) {
      const MatrixXd lower = block.matrixL().solve(MatrixXd::Identity(block.rows(), block.rows()));
      result.segment(first, block.rows()) = lower.colwise().squaredNorm().transpose();
      first += block.rows();
    }
    const MatrixXd beside = rest_.matrixL().solve(solved_.transpose());
    return result + beside.colwise().squaredNorm().transpose();
  }

 private:
  MatrixXd in_blocks(const MatrixXd& columns) const {
    MatrixXd result(columns.rows(), columns.cols());
    Index first = 0;
    for (const auto& block : blocks_) {
      result.middleRows(first, block.rows()) = block.solve(columns.middleRows(first, block.rows()));
      first += block.rows();
    }
    return result;
  }

  VectorXd tau_;
  std::vector<Eigen::LLT<MatrixXd>> blocks_;  // factors of the blocks of P
  MatrixXd shared_;                           // U
  MatrixXd solved_;                           // P⁻¹ U
  Eigen::LLT<MatrixXd> rest_;                 // I − Uᵀ P⁻¹ U
};

// −2 ℓ.
double misfit(const MountedEquations& equations, const MountedScatter& scatter) {
  const Covariance covariance(equations, scatter);
  const VectorXd along = covariance.tau().cwiseProduct(equations.along);
  return covariance.log_determinant() - along.dot(covariance.solve(along));
}

// Sums by kind, over the perturbations, 1 − variance given the readings / variance without them.
std::array<double, mounted_kinds> told_by(const MountedEquations& equations,
                                          const MountedScatter& scatter) {
  std::array<double, mounted_kinds> result{};
  if (equations.kind.empty()) return result;
  const VectorXd variance = Covariance(equations, scatter).inverse_diagonal();
  for (Index i = 0; i < variance.size(); ++i) {
    result[static_cast<std::size_t>(equations.kind[static_cast<std::size_t>(i)])] +=
        1 - variance[i];
  }
  return result;
}

double penalty(double scatter, double assumed) {
  return -2 * std::log(scatter / assumed) + 2 * scatter / assumed;
}

}  // namespace

Problem problem(const Dataset& dataset, const Scatter& scatter, const Model& model,
                Workers& workers) {
  const Forecast at = forecast(dataset, model);
  Problem result = problem(dataset, deviations(dataset, scatter.noise, at.reading_N));
  settle_motor_deviations(result, at);
  share_scatter(result, mounting_modes(dataset, model, workers), scatter.mounting.relative, at);
  return result;
}

bool is_told(const MountingScatter& scatter, Mounted kind) {
  return scatter.told_by[static_cast<std::size_t>(kind)] >= 1;
}

MountingScatter believed(MountingScatter scatter) {
  if (scatter.given) return scatter;
  for (std::size_t k = 0; k < mounted_kinds; ++k) {
    scatter.is_bounded |= scatter.relative[k] > most_believed_scatter[k];
    scatter.relative[k] = std::min(scatter.relative[k], most_believed_scatter[k]);
  }
  return scatter;
}

MountingScatter mounting_scatter(const Problem& problem, const Forecast& at,
                                 const MountingModes& modes, std::optional<double> given) {
  constexpr int evaluations = 60;
  constexpr double finely = 1e-3;  // share of the logarithms' range; readings resolve far less
  constexpr double least = 1e-3;   // times the assumed scatter
  constexpr double most = 100;
  MountingScatter result;
  result.given = given.has_value();
  for (const Mounted kind : modes.kind) result.present[static_cast<std::size_t>(kind)] = true;
  const MountedEquations equations = mounted_equations(problem, at, modes);
  result.mounted_again = equations.mounted_again;
  const auto told = told_by(equations, assumed_scatter);
  std::vector<std::size_t> free;
  for (std::size_t k = 0; k < mounted_kinds; ++k) {
    if (!result.present[k]) continue;
    const bool is_of_channels = k >= static_cast<std::size_t>(Mounted::gain);
    const double of_exponents = given.value_or(assumed_scatter[0]);
    result.relative[k] = !given           ? assumed_scatter[k]
                         : is_of_channels ? of_exponents * assumed_scatter[k] / assumed_scatter[0]
                                          : of_exponents;
    if (!given && told[k] >= 1) free.push_back(k);
  }
  const auto at_logarithms = [&](const std::vector<double>& x) {
    MountedScatter scatter = result.relative;
    for (std::size_t i = 0; i < free.size(); ++i) {
      scatter[free[i]] = assumed_scatter[free[i]] * std::exp(x[i]);
    }
    return scatter;
  };
  if (!free.empty()) {
    const std::vector<Interval> box(free.size(), Interval{std::log(least), std::log(most)});
    const Minimum best = refine(
        [&](const std::vector<double>& x) {
          const MountedScatter scatter = at_logarithms(x);
          double surprise = misfit(equations, scatter);
          for (const std::size_t k : free) surprise += penalty(scatter[k], assumed_scatter[k]);
          return surprise;
        },
        box, std::vector<double>(free.size(), 0.0), evaluations * static_cast<int>(free.size() + 1),
        finely);
    result.relative = at_logarithms(best.at);
  }
  result.told_by = told_by(equations, result.relative);
  return result;
}

}  // namespace reeve::diagnosis
