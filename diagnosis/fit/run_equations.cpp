#include "diagnosis/fit/run_equations.hpp"

#include <map>
#include <utility>

namespace reeve::diagnosis {

using Eigen::Index;

std::vector<RunEquations> run_equations(const Problem& problem, const Eigen::MatrixXd& jacobian,
                                        const Eigen::VectorXd& residuals) {
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

Eigen::VectorXd column_scale(const Eigen::MatrixXd& jacobian) {
  const Eigen::VectorXd lengths = jacobian.colwise().norm().transpose();
  return lengths.unaryExpr([](double length) { return length > 0 ? 1 / length : 1.0; });
}

}  // namespace reeve::diagnosis
