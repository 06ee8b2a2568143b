#include "diagnosis/verdict/residual_structure.hpp"

#include "diagnosis/fit/mounted_draws.hpp"
#include "diagnosis/fit/null_model.hpp"

namespace reeve::diagnosis {

ResidualStructure residual_structure(const Problem& problem, const Model& model,
                                     const MountingScatter& mounting, double alpha,
                                     const Replicates& replicates, Workers& workers,
                                     const std::function<bool()>& stop) {
  const Dataset& training = *problem.dataset;
  const Forecast at = forecast(training, model);
  const Projection projection(problem, model, at);
  const Eigen::VectorXd left = projection.taken_out(residuals(problem, at));
  const auto tests = structure_tests(problem, at, projection);
  const auto judged_by = [&](const MountedDraws* mounted) {
    const NullModel null_model(problem, projection, at, replicates.seed, replicates.count, mounted);
    return find_structure(problem, tests, left, null_model, workers, stop);
  };
  ResidualStructure result{row_scatter(problem, at), judged_by(nullptr)};
  if (result.structure.p_value < alpha && !problem.shared.empty() && !stop()) {
    const MountedDraws mounted(training, model, mounting);
    result.structure = judged_by(&mounted);
  }
  return result;
}

}  // namespace reeve::diagnosis
