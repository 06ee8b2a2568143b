// What a change of the model gains on each held-out run by itself: whether the gain is everywhere,
// or one mounting's.
#pragma once

#include <cstddef>
#include <vector>

#include "causes/model.hpp"
#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

struct RunGain {
  std::size_t run = 0;  // in MeasuredData::runs
  std::size_t cells = 0;
  double rms_before_N = 0;
  double rms_after_N = 0;
  double rms_noise_N = 0;  // of the residuals that are noise alone
};

// In the order in which the data name the runs.
std::vector<RunGain> run_gains(const Problem& held_out, const Model& before, const Model& after);

}  // namespace reeve::diagnosis
