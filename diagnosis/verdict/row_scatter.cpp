#include "diagnosis/verdict/row_scatter.hpp"

#include <cmath>
#include <vector>

#include "numerics/minimise.hpp"

namespace reeve::diagnosis {
namespace {

// Half of chi-squared's 99.9 % of one degree of freedom, on its edge.
constexpr double clearly = 4.75;
constexpr double least = 1e-4;
constexpr double most = 1;

struct RowAlong {
  double length = 0;    // |s|
  double residual = 0;  // z
};

std::vector<RowAlong> rows_along(const Problem& problem, const Forecast& at) {
  const Eigen::VectorXd left = residuals(problem, at);
  const Eigen::VectorXd along = at.reading_N.cwiseQuotient(problem.deviation_N);
  std::vector<RowAlong> rows;
  for (const DatasetRow& row : problem.dataset->rows) {
    const auto first = static_cast<Eigen::Index>(row.first);
    const auto size = static_cast<Eigen::Index>(row.last - row.first);
    if (!row.has_motor_tension || row.motor_deviation_N > 0 || size < 2) continue;
    const double length = along.segment(first, size).norm();
    if (!(length > 0)) continue;
    rows.push_back({length, along.segment(first, size).dot(left.segment(first, size)) / length});
  }
  return rows;
}

// −ℓ but for a constant.
double misfit(const std::vector<RowAlong>& rows, double relative) {
  double sum = 0;
  for (const RowAlong& row : rows) {
    const double variance = 1 + std::pow(relative * row.length, 2);
    sum += 0.5 * (std::log(variance) + row.residual * row.residual / variance);
  }
  return sum;
}

}  // namespace

std::optional<RowScatter> row_scatter(const Problem& problem, const Forecast& at) {
  constexpr int evaluations = 60;
  const std::vector<RowAlong> rows = rows_along(problem, at);
  if (rows.empty()) return std::nullopt;
  const Minimum best =
      minimise([&](const std::vector<double>& x) { return misfit(rows, std::exp(x[0])); },
               {{std::log(least), std::log(most)}}, evaluations);
  const RowScatter found{std::exp(best.at[0]), misfit(rows, 0) - best.value};
  return found.log_likelihood_gain > clearly ? std::optional(found) : std::nullopt;
}

}  // namespace reeve::diagnosis
