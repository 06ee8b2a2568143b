// How well any model could do on held-out runs: "as good as the noise allows".
//
// The true model leaves residuals that are noise alone. In units of their standard deviation the
// sum of their squares then is chi-squared with as many degrees of freedom ν as the runs have, so
// that over a model that leaves the residuals e it gains
//
//   (|e|² − χ²_ν) / 2 in log-likelihood:  (|e|² − ν) / 2 on average,
//                                         and 95 % of the time between the quantiles of χ²_ν.
//
// A model that gains less than that misses something. The standard deviations are taken as known;
// where they were estimated from what the model leaves, and not from repeated readings, the limit
// is that of a model that leaves as much.
#pragma once

#include "causes/model.hpp"
#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

struct NoiseLimit {
  double log_likelihood_gain = 0;
  double low = 0;
  double high = 0;
  double rms_N = 0;  // of the residuals that are noise alone
};

NoiseLimit noise_limit(const Problem& held_out, const Model& before);

}  // namespace reeve::diagnosis
