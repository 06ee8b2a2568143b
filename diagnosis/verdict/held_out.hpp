// Gain of a change of the model on held-out runs.
//
// Root of the mean squared residual, before and after, in newton; reduction = 1 − after / before.
// The interval is that of the middle 95 % of the Bayesian bootstrap: runs (readings where fewer
// than five runs were held out) weighed by random shares of a whole, uniform over all such shares.
// None is ever left out altogether, so that what shows in one run of five alone does not come and
// go as with runs drawn anew.
//
// Source: D. B. Rubin, Annals of Statistics 9 (1981) 130.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

struct HeldOut {
  double rms_before_N = 0;
  double rms_after_N = 0;
  double reduction = 0;
  double low = 0;
  double high = 0;
  double log_likelihood_gain = 0;
  double gain_low = 0;
  double gain_high = 0;
  double expected_gain = 0;  // if the later model were right
};

HeldOut held_out_gain(const Problem& held_out, const Forecast& before, const Forecast& after,
                      std::uint64_t seed);

// How well any model could do on these readings: "as good as the noise allows".
//
// The true model leaves residuals that are noise alone. In units of their standard deviation the
// sum of their squares then is chi-squared with as many degrees of freedom ν as the readings have,
// so that over a model that leaves the residuals e it gains
//
//   (|e|² − χ²_ν) / 2 in log-likelihood:  (|e|² − ν) / 2 on average,
//                                         and 95 % of the time between the quantiles of χ²_ν.
//
// A model that gains less than that misses something. The standard deviations are taken as known;
// where they were estimated from what the model leaves, and not from repeated readings, the limit
// is that of a model that leaves as much.
struct NoiseLimit {
  double log_likelihood_gain = 0;
  double low = 0;
  double high = 0;
  double rms_N = 0;  // RMS of the residuals that are noise alone
};

NoiseLimit noise_limit(const Problem& held_out, const Forecast& before);

// Gain of a change of the model on each run by itself. It shows whether all runs gain, or one
// mounting.
struct RunGain {
  std::size_t run = 0;  // in MeasuredData::runs
  std::size_t cells = 0;
  double rms_before_N = 0;
  double rms_after_N = 0;
  double rms_noise_N = 0;  // RMS of the residuals that are noise alone
};

// The runs stand in the order in which the data name them.
std::vector<RunGain> run_gains(const Problem& held_out, const Forecast& before,
                               const Forecast& after);

}  // namespace reeve::diagnosis
