// Residuals whose scatter is partly shared, made independent.
//
// In units of their own noise, and with what a change of free scales could explain taken out, the
// readings of a mounting (mounting.hpp) have the covariance I + V Vᵀ, V = U S Wᵀ. Then
//
//   (I + V Vᵀ)^{-1/2} = I − U (1 − (1 + S²)^{-1/2}) Uᵀ
//
// leaves them with a covariance of I. An ordinary least-squares fit of whitened residuals is the
// generalised one (A. C. Aitken, Proc. R. Soc. Edinburgh 55, 1935).
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::diagnosis {

// Scatter that the readings of one mounting share.
struct SharedScatter {
  std::vector<Eigen::Index> cells;
  Eigen::MatrixXd axes;    // U, a row for each of the cells
  Eigen::VectorXd shrunk;  // 1 − (1 + S²)^{-1/2}
  // Effect of one standard deviation of each thing on the cells, in units of their noise, before
  // free scales are taken out.
  Eigen::MatrixXd loadings;
};

// `seen` is the loadings with free scales taken out.
SharedScatter shared_scatter(std::vector<Eigen::Index> cells, Eigen::MatrixXd loadings,
                             const Eigen::MatrixXd& seen);

using Whitening = std::vector<SharedScatter>;

// Each column by itself.
void whiten(const Whitening& whitening, Eigen::Ref<Eigen::MatrixXd> columns);

// Adds what mountings drawn at random do. Uses the numbers of the stream from `first` on.
void add_shared_draws(const Whitening& whitening, std::uint64_t seed, std::uint32_t stream,
                      std::uint64_t first, Eigen::VectorXd& readings);

}  // namespace reeve::diagnosis
