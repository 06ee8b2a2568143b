// What the held-out runs say of the named causes, of each and of all together, and of the models
// that they were weighed against. Every number of a diagnosis that needs these runs, but for those
// of the withdrawal, is taken here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "causes/model.hpp"
#include "diagnosis/fit/mounting_scatter.hpp"
#include "diagnosis/fit/problem.hpp"
#include "diagnosis/verdict/aliases.hpp"
#include "diagnosis/verdict/held_out.hpp"

namespace reeve::diagnosis {

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
struct NoiseLimit {
  double log_likelihood_gain = 0;
  double low = 0;
  double high = 0;
  double rms_N = 0;  // of the residuals that are noise alone
};

NoiseLimit noise_limit(const Problem& held_out, const Model& before);

// What a change of the model gains on each held-out run by itself: whether the gain is everywhere,
// or one mounting's.
struct RunGain {
  std::size_t run = 0;  // in MeasuredData::runs
  std::size_t cells = 0;
  double rms_before_N = 0;
  double rms_after_N = 0;
  double rms_noise_N = 0;  // of the residuals that are noise alone
};

// In the order in which the data name the runs.
std::vector<RunGain> run_gains(const Problem& held_out, const Model& before, const Model& after);

// How the named causes together, or others in the place of one of them, explain the data.
struct WeighedCauses {
  std::vector<std::string> causes;
  double gain = 0;  // in log-likelihood on the training runs, over the nominal model
  std::optional<HeldOut> held_out;
};

struct Confirmation {
  std::vector<WeighedCauses> weighed;
  // The rest is nothing where no runs are held out.
  std::vector<std::optional<HeldOut>> of_causes;  // with each over without it, all others kept
  std::optional<HeldOut> together;                // all over none
  std::optional<NoiseLimit> noise_limit;
  std::vector<RunGain> run_gains;
};

// `training` is seen from the extended model; `rivals` is parallel to the causes.
Confirmation confirmation(const Problem& training, const Scatter& scatter, const Model& nominal,
                          const Model& extended, const std::vector<AppliedCause>& causes,
                          const std::vector<std::vector<Rival>>& rivals, const Dataset& held_out,
                          std::uint64_t seed, Workers& workers);

}  // namespace reeve::diagnosis
