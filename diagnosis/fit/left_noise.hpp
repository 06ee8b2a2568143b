// The scatter of readings where nothing tells it but what a model leaves of them.
#pragma once

#include <optional>

#include "causes/model.hpp"
#include "diagnosis/fit/mounting.hpp"
#include "diagnosis/fit/noise.hpp"

namespace reeve::diagnosis {

Noise noise_left_by(const Dataset& dataset, const Model& model);

// Within each mounting: beside what the mounting itself could have changed. Nothing where that
// leaves too few readings.
std::optional<Noise> noise_left_within_mountings(const Dataset& dataset, const Model& model,
                                                 const MountingModes& modes);

}  // namespace reeve::diagnosis
