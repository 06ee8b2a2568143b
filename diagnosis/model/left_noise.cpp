#include "diagnosis/model/left_noise.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "diagnosis/model/null_model.hpp"
#include "diagnosis/model/problem.hpp"
#include "diagnosis/model/scatter_fit.hpp"

namespace reeve::diagnosis {
namespace {

// In newton, and so sure that no reading is near what a sensor cannot read below.
constexpr double sure_N = 1e-6;

// The weight of a reading beside the others before its noise is known.
double weight(double reading_N, double middle_N) {
  return 1 / (std::abs(reading_N) + 0.1 * middle_N);
}

}  // namespace

Noise noise_left_by(const Dataset& dataset, const Model& model) {
  const auto cells = static_cast<Eigen::Index>(dataset.cells.size());
  Problem plain = problem(dataset, Eigen::VectorXd::Constant(cells, sure_N));
  plain.motor_deviation_N.resize(0);  // that is part of what is left
  const Forecast at = forecast(dataset, model);
  return noise_of_residuals(dataset, at, sure_N * own_residuals(plain, at),
                            static_cast<double>(parameter_count(model)));
}

std::optional<Noise> noise_left_within_mountings(const Dataset& dataset, const Model& model,
                                                 const MountingModes& modes) {
  const auto cells = static_cast<Eigen::Index>(dataset.cells.size());
  const Forecast at = forecast(dataset, model);
  Problem plain = problem(dataset, Eigen::VectorXd::Constant(cells, sure_N));
  plain.motor_deviation_N.resize(0);
  const Eigen::VectorXd left = sure_N * own_residuals(plain, at);
  const double scaled = dataset.degrees_of_freedom() / static_cast<double>(cells);
  // A seized contact may leave a model in which nothing is pulled.
  const double middle = std::max(at.reading_N.mean(), least_absolute(dataset));
  Eigen::VectorXd known = Eigen::VectorXd::Zero(cells);
  std::vector<std::size_t> row_of;
  for (std::size_t r = 0; r < dataset.rows.size(); ++r) {
    const DatasetRow& row = dataset.rows[r];
    for (std::size_t i = row.first; i < row.last; ++i) {
      const auto cell = static_cast<Eigen::Index>(i);
      known[cell] = motor_variance(row, at.by_scale[cell]);
      row_of.push_back(r);
    }
  }
  const std::vector<bool> tells = tell_of_noise(dataset);
  std::vector<ScatterSample> samples;
  for (const Mounting& mounting : mountings(dataset)) {
    Eigen::VectorXd weights = at.reading_N(mounting.cells);
    for (double& of : weights) of = weight(of, middle);
    const Eigen::MatrixXd basis = orthonormal_basis(
        weights.asDiagonal() * Eigen::MatrixXd(modes.by_share_N(mounting.cells, Eigen::all)));
    const Eigen::VectorXd weighted = weights.cwiseProduct(Eigen::VectorXd(left(mounting.cells)));
    const Eigen::VectorXd own = weighted - basis * (basis.transpose() * weighted);
    for (Eigen::Index i = 0; i < own.size(); ++i) {
      const Eigen::Index cell = mounting.cells[static_cast<std::size_t>(i)];
      const std::size_t channel = dataset.cells[static_cast<std::size_t>(cell)].channel;
      if (!tells[channel]) continue;
      samples.push_back({std::max(at.reading_N[cell], 0.0), own[i] / weights[i],
                         scaled * (1 - basis.row(i).squaredNorm()), known[cell],
                         row_of[static_cast<std::size_t>(cell)]});
    }
  }
  return noise_of_samples(dataset, std::move(samples));
}

}  // namespace reeve::diagnosis
