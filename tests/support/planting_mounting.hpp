// What mounting a routing anew does to planted readings: in each run and routing, the exponent of
// each contact and the gain of each sensor are a little other ones, normal about the nominal.
//
// Oracle: with what mountings share, the readings of one mounting have the covariance
// diag(sd^2) + sum of tau_k^2 j_k j_k^T, j_k the change of its expected readings by the k-th
// exponent or gain, taken by finite differences of the planted tensions.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

#include "tests/support/planting_noise.hpp"
#include "tests/support/planting_readings.hpp"

namespace reeve::testing {

bool differs_by_mounting(const NoiseLevel& noise);

// Rows of one mounting, which is a run and a routing, have the same factors.
Experiment mounted(const Experiment& experiment, const NoiseLevel& noise, std::uint64_t seed);

// Readings of one mounting, by their places among all, and the covariance of their scatter, N^2.
struct MountedScatter {
  std::vector<Eigen::Index> cells;
  Eigen::MatrixXd covariance;
};
std::vector<MountedScatter> mounted_scatter(const Truth& truth, const Experiment& experiment,
                                            const NoiseLevel& noise);

// What the mountings of the second experiment do to its expected readings, less the first order of
// it, which is all that the covariance knows: exponents that differ by several per cent bend what
// many precise readings see.
Readings beyond_first_order(const Truth& truth, const Experiment& experiment,
                            const Experiment& mounted);

// ln N(readings | expected) - ln N(readings | other), both with that covariance.
double mounted_log_likelihood_ratio(const Truth& truth, const Experiment& experiment,
                                    const NoiseLevel& noise, const Readings& other,
                                    const Readings& readings);

}  // namespace reeve::testing
