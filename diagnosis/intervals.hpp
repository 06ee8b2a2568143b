// 95 % intervals of a model's fitted parameters.
//
// Runs are resampled and the parameters fitted again to each sample (to first order about the fit:
// one Gauss–Newton step, for which each run contributes Jᵀ J and Jᵀ e). The standard deviation of
// the samples, widened by Student's t for as many runs, gives the interval; it is never narrower
// than what independent readings of the estimated noise would give, and lies within the range of
// the parameter. With fewer than four runs only the latter is known.
#pragma once

#include <cstdint>
#include <vector>

#include "diagnosis/problem.hpp"

namespace reeve {

struct ParameterInterval {
  double low = 0;
  double high = 0;
};

// Parallel to the effects and their parameters.
std::vector<std::vector<ParameterInterval>> parameter_intervals(const Problem& problem,
                                                                const Model& model,
                                                                std::uint64_t seed);

}  // namespace reeve
