// How likely the readings of planted data are under a model, by the noise as it was planted:
//
//   normal, by mounting        |e|^2 = (y - m)^T C^-1 (y - m), C at the truth
//   Student's t, by reading    e^2 = (d + 1) ln(1 + z^2 / (d - 2)), z in standard deviations
//
// so that -ln L = |e|^2 / 2 up to what all models share. The effects of mountings beyond the first
// order, which C does not know, are taken out of the readings.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <optional>
#include <vector>

#include "causes/model.hpp"
#include "diagnosis/dataset.hpp"
#include "tests/support/planting.hpp"

namespace reeve::bench {

class PlantedLikelihood {
 public:
  // All that is given must outlive it.
  PlantedLikelihood(const testing::Planted& planted, const diagnosis::Dataset& dataset);

  // e; nothing where the model has no tensions.
  std::optional<Eigen::VectorXd> residuals(const causes::Model& model) const;

 private:
  struct Mounting {
    std::vector<Eigen::Index> cells;  // cells of the dataset
    Eigen::LLT<Eigen::MatrixXd> covariance;
  };

  const diagnosis::Dataset& dataset_;
  int tail_degrees_;
  Eigen::VectorXd measured_N_;
  std::vector<Mounting> mountings_;
};

}  // namespace reeve::bench
