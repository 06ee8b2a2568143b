// The causes that the data could show, each about each of its subjects, before anything is fitted:
// effects of nominal size, which change nothing, and those without size as they are. A wrong grasp
// is there once for each pair of grasps.
#pragma once

#include <vector>

#include "causes/cause.hpp"
#include "causes/model.hpp"

namespace reeve::diagnosis {

// A coefficient that the hardware knows is none of them. `force_scale` as of the data
// (dataset.hpp).
std::vector<Effect> candidates(const Survey& survey, const Hardware& hardware,
                               double force_scale = 1);

// Values at which the law of a candidate with parameters of shape is tried: the size is nominal.
std::vector<std::vector<double>> shapes(const Effect& candidate,
                                        const std::vector<Parameter>& parameters);

}  // namespace reeve::diagnosis
