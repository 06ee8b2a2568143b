// What the held-out runs say of the named causes, of each and of all together, and of the models
// that they were weighed against. Every number of a diagnosis that needs these runs, but for those
// of the withdrawal, is taken here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/fit/scatter.hpp"
#include "diagnosis/verdict/aliases.hpp"
#include "diagnosis/verdict/held_out.hpp"
#include "diagnosis/verdict/noise_limit.hpp"
#include "diagnosis/verdict/run_gain.hpp"

namespace reeve::diagnosis {

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
