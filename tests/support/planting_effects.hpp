// The effects that are hidden in planted data: the library's causes by name and parameter, and
// three that no cause explains.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/support/planting_experiment.hpp"
#include "tests/support/planting_nature.hpp"
#include "tests/support/planting_rig.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve::testing {

enum class EffectKind : std::uint8_t {
  tube_friction,
  sheath_friction,
  bearing_friction,
  load_dependent_friction,
  speed_dependent_friction,
  wear,
  temperature,
  bending_stiffness,
  bearing_drag,
  sensor_gain,
  sensor_offset,
  pretension,
  sheath_angle,
  wrong_grasp,
  seized_contact,
  crosstalk,  // channel j reads T_j + c T_{j+1}, the next one that its row has
  drift,      // readings grow with the order of rows, by 1 + d order / rows
  wave,       // and swing with it, by 1 + A sin(2 pi order / period)
  // Of drives and sensors (planting_rig.hpp).
  motor_gain,
  motor_offset,
  constant_loss,
  viscous_loss,
  hysteresis,
  cross_talk,
  channel_drift,
  saturation,
  dead_channel,
  swapped_channels,
};
const char* planted_name(EffectKind kind);
const std::vector<EffectKind>& library_effects();
const std::vector<EffectKind>& unknown_effects();
const std::vector<EffectKind>& rig_effects();

enum class EffectSize : std::uint8_t { small, medium, large };
const char* size_name(EffectSize size);

// What the sensors make of the tensions. On one channel the order is pretension, crosstalk, the
// electronics, gain, offset, then drift and wave.
struct Sensors {
  std::map<std::string, double> gain, offset_N;
  double pretension_N = 0;  // every strand reads T + T_p
  double crosstalk = 0;
  double drift = 0;
  double wave_amplitude = 0;
  double wave_period_rows = 17;
};

struct Truth {
  Nature nature;
  Drive drive;
  Electronics electronics;
  Sensors sensors;
};

struct PlantedParameter {
  std::string name;
  double value;
};

// An effect of given size: what to call it and how to make it happen.
struct PlantedEffect {
  EffectKind kind = EffectKind::tube_friction;
  std::string name;  // of the cause: sensor_gain[T3]
  std::vector<PlantedParameter> parameters;
  std::function<void(Truth&)> impose;
};

// Effects that are one number of the truth.
template <typename Number>
PlantedEffect one_number(EffectKind kind, const char* parameter, double value, Number where) {
  return {kind, planted_name(kind), {{parameter, value}}, [where, value](Truth& truth) {
            where(truth) = value;
          }};
}

void add_needs(EffectKind kind, ExperimentNeeds& needs);

// Channel, finger, routing, contact or grasp are drawn from those of the experiment. Wrong grasps
// and seized contacts have no size.
PlantedEffect draw_effect(EffectKind kind, EffectSize size, const Experiment& experiment,
                          Dice& dice);

}  // namespace reeve::testing
