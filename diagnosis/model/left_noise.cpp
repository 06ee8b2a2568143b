#include "diagnosis/model/left_noise.hpp"

#include "diagnosis/model/problem.hpp"

namespace reeve::diagnosis {

Noise noise_left_by(const Dataset& dataset, const Model& model) {
  // In newton, and so sure that no reading is near what a sensor cannot read below.
  constexpr double sure_N = 1e-6;
  const auto cells = static_cast<Eigen::Index>(dataset.cells.size());
  const Problem plain = problem(dataset, Eigen::VectorXd::Constant(cells, sure_N));
  return noise_of_residuals(dataset, sure_N * own_residuals(plain, forecast(dataset, model)),
                            static_cast<double>(parameter_count(model)));
}

}  // namespace reeve::diagnosis
