#include "tests/support/planting_rig_effects.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "tests/support/planting_readings.hpp"
#include "tests/support/planting_walk.hpp"

namespace reeve::testing {
namespace {

using Sizes = std::array<double, 3>;

std::string draw_strand(const Experiment& experiment, Dice& dice) {
  std::vector<std::string> strands;
  std::copy_if(experiment.channels.begin(), experiment.channels.end(), std::back_inserter(strands),
               is_strand);
  return dice.pick(strands);
}

template <typename Values>
PlantedEffect of_channel(EffectKind kind, const char* parameter, double value,
                         const Experiment& experiment, Dice& dice, Values values) {
  const std::string channel = draw_strand(experiment, dice);
  return {kind,
          std::string(planted_name(kind)) + "[" + channel + "]",
          {{parameter, value}},
          [=](Truth& truth) { values(truth)[channel] = value; }};
}

// Nothing beyond a limit that is a share of the most that the channel would read.
PlantedEffect draw_saturation(EffectSize size, const Experiment& experiment, Dice& dice) {
  const std::string channel = draw_strand(experiment, dice);
  const Readings readings = expected_readings({}, experiment);
  double greatest = 0;
  for (std::size_t row = 0; row < readings.size(); ++row) {
    const auto& measured = experiment.rows[row].measured;
    for (std::size_t i = 0; i < measured.size(); ++i) {
      if (measured[i] == channel) greatest = std::max(greatest, readings[row][i]);
    }
  }
  const double limit = Sizes{0.8, 0.6, 0.4}[static_cast<std::size_t>(size)] * greatest;
  return {EffectKind::saturation,
          "saturation[" + channel + "]",
          {{"share", 1}, {"limit", limit}},
          [=](Truth& truth) { truth.electronics.limit_N[channel] = limit; }};
}

PlantedEffect draw_dead_channel(const Experiment& experiment, Dice& dice) {
  const std::string channel = draw_strand(experiment, dice);
  return {EffectKind::dead_channel, "dead_channel[" + channel + "]", {}, [=](Truth& truth) {
            truth.electronics.dead.insert(channel);
          }};
}

// Two strands of one row, in the order of the columns.
PlantedEffect draw_swapped_channels(const Experiment& experiment, Dice& dice) {
  std::vector<std::string> strands;
  const auto& measured = dice.pick(experiment.rows).measured;
  std::copy_if(experiment.channels.begin(), experiment.channels.end(), std::back_inserter(strands),
               [&](const std::string& channel) {
                 return is_strand(channel) &&
                        std::find(measured.begin(), measured.end(), channel) != measured.end();
               });
  if (strands.size() < 2) return draw_swapped_channels(experiment, dice);
  const std::string one = dice.pick(strands);
  std::string other = one;
  while (other == one) other = dice.pick(strands);
  const auto before = [&](const std::string& a, const std::string& b) {
    return std::find(strands.begin(), strands.end(), a) <
           std::find(strands.begin(), strands.end(), b);
  };
  const auto [first, second] = before(one, other) ? std::pair(one, other) : std::pair(other, one);
  return {EffectKind::swapped_channels,
          "swapped_channels[" + first + "," + second + "]",
          {},
          [first = first, second = second](Truth& truth) {
            truth.electronics.exchanged = {first, second};
          }};
}

}  // namespace

const std::vector<EffectKind>& rig_effects() {
  static const std::vector<EffectKind> kinds{
      EffectKind::motor_gain,      EffectKind::motor_offset, EffectKind::constant_loss,
      EffectKind::viscous_loss,    EffectKind::hysteresis,   EffectKind::cross_talk,
      EffectKind::channel_drift,   EffectKind::saturation,   EffectKind::dead_channel,
      EffectKind::swapped_channels};
  return kinds;
}

PlantedEffect draw_rig_effect(EffectKind kind, EffectSize size, const Experiment& experiment,
                              Dice& dice) {
  const auto of = [size](const Sizes& sizes) { return sizes[static_cast<std::size_t>(size)]; };
  switch (kind) {
    case EffectKind::motor_gain:
      return one_number(kind, "gain", of({0.97, 0.93, 0.85}),
                        [](Truth& t) -> double& { return t.drive.gain; });
    case EffectKind::motor_offset:
      return one_number(kind, "offset", of({0.3, 0.8, 2}),
                        [](Truth& t) -> double& { return t.drive.offset_N; });
    case EffectKind::constant_loss:
      return one_number(kind, "force", of({0.3, 0.8, 2}),
                        [](Truth& t) -> double& { return t.drive.loss_N; });
    case EffectKind::viscous_loss:
      return one_number(kind, "slope", of({0.01, 0.03, 0.08}),
                        [](Truth& t) -> double& { return t.drive.loss_Ns_mm; });
    case EffectKind::hysteresis:
      return one_number(kind, "change", of({0.1, 0.25, 0.5}),
                        [](Truth& t) -> double& { return t.nature.release_change; });
    case EffectKind::cross_talk:
      return of_channel(
          kind, "part", of({0.03, 0.06, 0.15}), experiment, dice,
          [](Truth & t) -> auto& { return t.electronics.part_of_neighbours; });
    case EffectKind::channel_drift:
      return of_channel(
          kind, "drift", of({0.3, 0.6, 1.2}), experiment, dice,
          [](Truth & t) -> auto& { return t.electronics.drift_N; });
    case EffectKind::saturation:
      return draw_saturation(size, experiment, dice);
    case EffectKind::dead_channel:
      return draw_dead_channel(experiment, dice);
    case EffectKind::swapped_channels:
      return draw_swapped_channels(experiment, dice);
    default:
      throw std::logic_error("draw_rig_effect: unknown kind");
  }
}

}  // namespace reeve::testing
