#include "bench/confusion/planted_likelihood.hpp"

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "diagnosis/fit/forecast.hpp"
#include "tests/support/planting_mounting.hpp"

namespace reeve::bench {
namespace {

using Eigen::Index;

// Parallel to the planted cells; nothing of one that the dataset does not have.
std::vector<std::optional<Index>> places_in(const diagnosis::Dataset& dataset,
                                            const testing::Planted& planted) {
  std::map<std::pair<std::size_t, std::string>, Index> place;
  for (std::size_t i = 0; i < dataset.cells.size(); ++i) {
    const diagnosis::Cell& cell = dataset.cells[i];
    place[{cell.reading, dataset.data->channels[cell.channel].name}] = static_cast<Index>(i);
  }
  std::vector<std::optional<Index>> places;
  for (const testing::PlantedCell& cell : planted.cells) {
    const auto found = place.find({cell.row, cell.channel});
    places.push_back(found == place.end() ? std::nullopt : std::optional(found->second));
  }
  return places;
}

}  // namespace

PlantedLikelihood::PlantedLikelihood(const testing::Planted& planted,
                                     const diagnosis::Dataset& dataset)
    : dataset_(dataset),
      tail_degrees_(planted.noise.tail_degrees),
      measured_N_(static_cast<Index>(dataset.cells.size())) {
  for (std::size_t i = 0; i < dataset.cells.size(); ++i) {
    measured_N_[static_cast<Index>(i)] = dataset.cells[i].measured_N;
  }
  const auto places = places_in(dataset, planted);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i]) measured_N_[*places[i]] -= planted.cells[i].beyond_N;
  }
  for (const testing::MountedScatter& scatter :
       testing::mounted_scatter(planted.truth, planted.experiment, planted.noise)) {
    std::vector<Index> own, there;
    for (std::size_t i = 0; i < scatter.cells.size(); ++i) {
      const auto& place = places[static_cast<std::size_t>(scatter.cells[i])];
      if (!place) continue;
      own.push_back(static_cast<Index>(i));
      there.push_back(*place);
    }
    if (there.empty()) continue;
    const Eigen::MatrixXd covariance = scatter.covariance(own, own);
    mountings_.push_back({std::move(there), Eigen::LLT<Eigen::MatrixXd>(covariance)});
  }
}

std::optional<Eigen::VectorXd> PlantedLikelihood::residuals(const causes::Model& model) const {
  const auto forecast = diagnosis::try_forecast(dataset_, model);
  if (!forecast) return std::nullopt;
  Eigen::VectorXd e = measured_N_ - forecast->reading_N;
  for (const Mounting& mounting : mountings_) {
    Eigen::VectorXd off = e(mounting.cells);
    mounting.covariance.matrixL().solveInPlace(off);
    e(mounting.cells) = off;
  }
  if (tail_degrees_ > 0) {
    const double degrees = tail_degrees_;
    for (double& z : e) {
      z = std::copysign(std::sqrt((degrees + 1) * std::log1p(z * z / (degrees - 2))), z);
    }
  }
  return e;
}

}  // namespace reeve::bench
