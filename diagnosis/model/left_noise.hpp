// The scatter of readings where nothing tells it but what a model leaves of them.
#pragma once

#include "causes/model.hpp"
#include "diagnosis/model/noise.hpp"

namespace reeve::diagnosis {

Noise noise_left_by(const Dataset& dataset, const Model& model);

}  // namespace reeve::diagnosis
