// What a change of the model gains on runs that its fit has not seen.
//
// Root of the mean squared residual, before and after, in newton; reduction = 1 − after / before.
// The interval is that of the middle 95 % of the Bayesian bootstrap: runs (readings where fewer
// than five runs were held out) weighed by random shares of a whole, uniform over all such shares.
// None is ever left out altogether, so that what shows in one run of five alone does not come and
// go as with runs drawn anew.
//
// Source: D. B. Rubin, Annals of Statistics 9 (1981) 130.
#pragma once

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

HeldOut held_out_gain(const Problem& held_out, const Model& before, const Model& after,
                      std::uint64_t seed);

}  // namespace reeve::diagnosis
