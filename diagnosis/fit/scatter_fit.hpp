// Fits the likeliest noise (noise.hpp) to samples of it, of all rows alike or of each group of rows
// by itself.
//
//   v = f_g² (absolute² + (relative T)²) + what is known of the motor tension
//   −2 ℓ = Σ k ln v + r² / v,   r² / (k v) beyond 3.5² as in robust_misfit of evidence.hpp
//
// of residuals r of which the part k of the variance is left. Readings beyond 3.5 standard
// deviations are wrong by accident and shape no noise. Least is −2 ℓ − 2 ln absolute − 2 ln
// relative: where samples hardly tell one of them the likeliest is often none, and readings at the
// other end of the range would weigh far too much; so it is about a standard error from that
// (Y. Chung, S. Rabe-Hesketh, V. Dorie, A. Gelman, J. Liu, Psychometrika 78, 2013). More parameters
// have to be clearly likelier: chance alone may make −2 ℓ fall so far in 1 of 1000 samples.
#pragma once

#include <vector>

#include "diagnosis/dataset.hpp"
#include "diagnosis/fit/noise.hpp"
#include "diagnosis/fit/scatter_samples.hpp"

namespace reeve::diagnosis {

// Standard deviations, beyond which a reading weighs as one there: it is wrong by accident.
inline constexpr double outlying = 3.5;

// How many degrees of freedom samples have together.
double degrees(const std::vector<ScatterSample>& samples);

// N: what no noise is below, so that a reading of 0 does not weigh infinitely.
double least_absolute(const Dataset& dataset);

// The scatter is alike in all rows.
Noise scatter_of_all(const Dataset& dataset, const std::vector<ScatterSample>& samples);

// The f of groups have the geometric mean 1, and a group that few samples tell has 1. Groups are
// judged by `free` samples, of which the estimate leaves most: the others are mixtures of several
// readings' scatter.
Noise likeliest_scatter(const Dataset& dataset, const std::vector<ScatterSample>& samples);

}  // namespace reeve::diagnosis
