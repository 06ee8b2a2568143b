// Effects of drives and sensors that are hidden in planted data (planting_rig.hpp has their
// formulas), and hysteresis of friction.
#pragma once

#include <vector>

#include "tests/support/planting_effects.hpp"

namespace reeve::testing {

const std::vector<EffectKind>& rig_effects();

// Of one of those kinds.
PlantedEffect draw_rig_effect(EffectKind kind, EffectSize size, const Experiment& experiment,
                              Dice& dice);

}  // namespace reeve::testing
