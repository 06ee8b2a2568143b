// All that is known of how readings scatter: by themselves (noise.hpp), and together with the
// others of their mounting (mounting_scatter.hpp).
#pragma once

#include "diagnosis/fit/mounting_scatter.hpp"
#include "diagnosis/fit/noise.hpp"
#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

struct Scatter {
  Noise noise;
  MountingScatter mounting;
};

// Seen from a model. Throws OutOfRange where it has no tensions.
Problem problem(const Dataset& dataset, const Scatter& scatter, const Model& model,
                Workers& workers);

}  // namespace reeve::diagnosis
