#include "tests/support/planting_effects.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "tests/support/planting_readings.hpp"
#include "tests/support/planting_seizure.hpp"
#include "tests/support/planting_walk.hpp"

namespace reeve::testing {
namespace {

using Sizes = std::array<double, 3>;

double pick(const Sizes& sizes, EffectSize size) { return sizes[static_cast<std::size_t>(size)]; }

double either_sign(double value, Dice& dice) { return dice.chance(0.5) ? value : -value; }

// An effect that is one number of the truth, by size.
struct NumberRow {
  EffectKind kind;
  const char* parameter;
  Sizes sizes;
  std::function<double&(Truth&)> where;
};

template <typename Part>
NumberRow row(EffectKind kind, const char* parameter, const Sizes& sizes, Part Truth::*part,
              double Part::*number) {
  return {kind, parameter, sizes, [=](Truth& t) -> double& { return t.*part.*number; }};
}

const std::vector<NumberRow>& number_rows() {
  static const std::vector<NumberRow> rows{
      row(EffectKind::tube_friction, "mu", {0.15, 0.12, 0.09}, &Truth::nature, &Nature::tube_mu),
      row(EffectKind::sheath_friction, "mu", {0.165, 0.15, 0.12}, &Truth::nature,
          &Nature::sheath_mu),
      row(EffectKind::bearing_friction, "mu", {0.02, 0.05, 0.1}, &Truth::nature,
          &Nature::bearing_mu),
      row(EffectKind::load_dependent_friction, "exponent", {0.05, 0.1, 0.2}, &Truth::nature,
          &Nature::load_exponent),
      row(EffectKind::speed_dependent_friction, "slope", {0.03, 0.06, 0.12}, &Truth::nature,
          &Nature::speed_slope),
      row(EffectKind::temperature, "slope", {0.002, 0.004, 0.008}, &Truth::nature,
          &Nature::temperature_slope_per_K),
      row(EffectKind::bending_stiffness, "force", {0.1, 0.3, 0.6}, &Truth::nature,
          &Nature::bending_force_N),
      row(EffectKind::bearing_drag, "force", {0.1, 0.3, 0.6}, &Truth::nature,
          &Nature::drag_force_N),
      row(EffectKind::pretension, "force", {0.1, 0.3, 0.6}, &Truth::sensors,
          &Sensors::pretension_N),
      row(EffectKind::crosstalk, "share", {0.05, 0.1, 0.2}, &Truth::sensors, &Sensors::crosstalk),
      row(EffectKind::drift, "drift", {0.1, 0.2, 0.4}, &Truth::sensors, &Sensors::drift),
      row(EffectKind::wave, "amplitude", {0.05, 0.1, 0.2}, &Truth::sensors,
          &Sensors::wave_amplitude),
      row(EffectKind::motor_gain, "gain", {0.97, 0.93, 0.85}, &Truth::drive, &Drive::gain),
      row(EffectKind::motor_offset, "offset", {0.3, 0.8, 2}, &Truth::drive, &Drive::offset_N),
      row(EffectKind::constant_loss, "force", {0.3, 0.8, 2}, &Truth::drive, &Drive::loss_N),
      row(EffectKind::viscous_loss, "slope", {0.01, 0.03, 0.08}, &Truth::drive, &Drive::loss_Ns_mm),
      row(EffectKind::hysteresis, "change", {0.1, 0.25, 0.5}, &Truth::nature,
          &Nature::release_change),
  };
  return rows;
}

PlantedEffect draw_wear(EffectSize size, Dice& dice) {
  const double change = pick({-0.15, -0.3, -0.5}, size);
  const double cycles = dice.log_real(300, 1000);
  return {EffectKind::wear, "wear", {{"change", change}, {"cycles", cycles}}, [=](Truth& truth) {
            truth.nature.wear_change = change;
            truth.nature.wear_cycles = cycles;
          }};
}

// Strands more often than motor-side segments, and only what every experiment row could have.
std::string draw_channel(const Experiment& experiment, Dice& dice) {
  std::vector<std::string> strands, others;
  for (const std::string& channel : experiment.channels) {
    (is_strand(channel) ? strands : others).push_back(channel);
  }
  return !others.empty() && dice.chance(0.2) ? dice.pick(others) : dice.pick(strands);
}

std::string draw_strand(const Experiment& experiment, Dice& dice) {
  std::vector<std::string> strands;
  std::copy_if(experiment.channels.begin(), experiment.channels.end(), std::back_inserter(strands),
               is_strand);
  return dice.pick(strands);
}

template <typename Values>
PlantedEffect of_channel(EffectKind kind, const char* parameter, double value,
                         const std::string& channel, Values values) {
  return {kind,
          std::string(planted_name(kind)) + "[" + channel + "]",
          {{parameter, value}},
          [=](Truth& truth) { values(truth)[channel] = value; }};
}

PlantedEffect draw_sensor_gain(EffectSize size, const Experiment& experiment, Dice& dice) {
  const std::string channel = draw_channel(experiment, dice);
  const double gain = 1 + either_sign(pick({0.03, 0.06, 0.12}, size), dice);
  return of_channel(
      EffectKind::sensor_gain, "gain", gain, channel,
      [](Truth & t) -> auto& { return t.sensors.gain; });
}

PlantedEffect draw_sensor_offset(EffectSize size, const Experiment& experiment, Dice& dice) {
  const std::string channel = draw_channel(experiment, dice);
  const double offset = either_sign(pick({0.1, 0.3, 0.6}, size), dice);
  return of_channel(
      EffectKind::sensor_offset, "offset", offset, channel,
      [](Truth & t) -> auto& { return t.sensors.offset_N; });
}

std::vector<std::string> words_of(const Experiment& experiment) {
  std::set<std::string> words;
  for (const ExperimentRow& row : experiment.rows) words.insert(row.condition.word);
  return {words.begin(), words.end()};
}

// Fingers that a sheath leads to.
std::vector<int> sheathed_fingers(const Experiment& experiment) {
  std::set<int> fingers;
  for (const std::string& word : words_of(experiment)) {
    for (const reference::Tendon& tendon : reference::read_tendons(word)) {
      for (std::size_t k = 0; k < tendon.kinds.size(); ++k) {
        if (tendon.kinds[k] != "sheath") continue;
        const auto [left, right] = tendon.sides(k);
        fingers.insert(std::max(finger_of_strand(left), finger_of_strand(right)));
      }
    }
  }
  fingers.erase(0);
  return {fingers.begin(), fingers.end()};
}

PlantedEffect draw_sheath_angle(EffectSize size, const Experiment& experiment, Dice& dice) {
  const int finger = dice.pick(sheathed_fingers(experiment));
  const double change = either_sign(pick({0.4, 0.8, 1.5}, size), dice);
  return {EffectKind::sheath_angle,
          "sheath_angle[" + std::to_string(finger) + "]",
          {{"change", change}},
          [=](Truth& truth) { truth.nature.sheath_change_rad[finger] = change; }};
}

bool jams(const std::string& word, const std::set<int>& held) {
  return reference_tensions(word, held, ReferenceDirection::pull, nominal_hardware()).jams;
}

// Another grasp that can be measured.
std::set<int> draw_actual(const std::string& word, const std::set<int>& recorded, Dice& dice) {
  std::vector<std::set<int>> grasps{{}};
  for (const int finger : fingers_of(word)) grasps.push_back({finger});
  std::erase_if(grasps, [&](const auto& held) { return held == recorded || jams(word, held); });
  return dice.pick(grasps);
}

PlantedEffect draw_wrong_grasp(const Experiment& experiment, Dice& dice) {
  std::set<std::pair<std::string, std::set<int>>> recorded;
  for (const auto& row : experiment.rows) recorded.emplace(row.condition.word, row.condition.held);
  // With all fingers closing alone there is no other grasp.
  std::erase_if(recorded, [](const auto& of) {
    const auto fingers = fingers_of(of.first);
    return std::all_of(fingers.begin(), fingers.end(),
                       [&](int finger) { return jams(of.first, {finger}); });
  });
  const auto [word, held] = dice.pick(std::vector(recorded.begin(), recorded.end()));
  const WrongGrasp wrong{word, held, draw_actual(word, held, dice)};
  return {EffectKind::wrong_grasp, "wrong_grasp[" + word + "]", {}, [=](Truth& truth) {
            truth.nature.wrong_grasps.push_back(wrong);
          }};
}

PlantedEffect draw_seized_contact(const Experiment& experiment, Dice& dice) {
  std::vector<SeizedContact> contacts;
  for (const std::string& word : words_of(experiment)) {
    for (const std::string& contact : seizable_contacts(word)) contacts.push_back({word, contact});
  }
  const SeizedContact seized = dice.pick(contacts);
  return {EffectKind::seized_contact,
          "seized_contact[" + seized.word + "," + seized.contact + "]",
          {},
          [=](Truth& truth) { truth.nature.seized.push_back(seized); }};
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
  const double limit = pick({0.8, 0.6, 0.4}, size) * greatest;
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

// With both.
std::vector<EffectKind> kinds_between(EffectKind first, EffectKind last) {
  std::vector<EffectKind> all;
  for (auto i = static_cast<int>(first); i <= static_cast<int>(last); ++i) {
    all.push_back(static_cast<EffectKind>(i));
  }
  return all;
}

}  // namespace

const char* planted_name(EffectKind kind) {
  constexpr std::array names{"tube_friction",
                             "sheath_friction",
                             "bearing_friction",
                             "load_dependent_friction",
                             "speed_dependent_friction",
                             "wear",
                             "temperature",
                             "bending_stiffness",
                             "bearing_drag",
                             "sensor_gain",
                             "sensor_offset",
                             "pretension",
                             "sheath_angle",
                             "wrong_grasp",
                             "seized_contact",
                             "crosstalk",
                             "drift",
                             "wave",
                             "motor_gain",
                             "motor_offset",
                             "constant_loss",
                             "viscous_loss",
                             "hysteresis",
                             "cross_talk",
                             "drift",
                             "saturation",
                             "dead_channel",
                             "swapped_channels"};
  return names[static_cast<std::size_t>(kind)];
}

const char* size_name(EffectSize size) {
  constexpr std::array names{"small", "medium", "large"};
  return names[static_cast<std::size_t>(size)];
}

const std::vector<EffectKind>& library_effects() {
  static const auto kinds = kinds_between(EffectKind::tube_friction, EffectKind::seized_contact);
  return kinds;
}

const std::vector<EffectKind>& unknown_effects() {
  static const auto kinds = kinds_between(EffectKind::crosstalk, EffectKind::wave);
  return kinds;
}

const std::vector<EffectKind>& rig_effects() {
  static const auto kinds = kinds_between(EffectKind::motor_gain, EffectKind::swapped_channels);
  return kinds;
}

void add_needs(EffectKind kind, ExperimentNeeds& needs) {
  needs.speed |= kind == EffectKind::speed_dependent_friction || kind == EffectKind::viscous_loss;
  needs.cycle |= kind == EffectKind::wear;
  needs.temperature |= kind == EffectKind::temperature;
  needs.bearings |= kind == EffectKind::bearing_friction || kind == EffectKind::bearing_drag;
}

PlantedEffect draw_effect(EffectKind kind, EffectSize size, const Experiment& experiment,
                          Dice& dice) {
  for (const NumberRow& each : number_rows()) {
    if (each.kind == kind)
      return one_number(kind, each.parameter, pick(each.sizes, size), each.where);
  }
  switch (kind) {
    case EffectKind::wear:
      return draw_wear(size, dice);
    case EffectKind::sensor_gain:
      return draw_sensor_gain(size, experiment, dice);
    case EffectKind::sensor_offset:
      return draw_sensor_offset(size, experiment, dice);
    case EffectKind::sheath_angle:
      return draw_sheath_angle(size, experiment, dice);
    case EffectKind::wrong_grasp:
      return draw_wrong_grasp(experiment, dice);
    case EffectKind::seized_contact:
      return draw_seized_contact(experiment, dice);
    case EffectKind::cross_talk:
      return of_channel(
          kind, "part", pick({0.03, 0.06, 0.15}, size), draw_strand(experiment, dice),
          [](Truth & t) -> auto& { return t.electronics.part_of_neighbours; });
    case EffectKind::channel_drift:
      return of_channel(
          kind, "drift", pick({0.3, 0.6, 1.2}, size), draw_strand(experiment, dice),
          [](Truth & t) -> auto& { return t.electronics.drift_N; });
    case EffectKind::saturation:
      return draw_saturation(size, experiment, dice);
    case EffectKind::dead_channel:
      return draw_dead_channel(experiment, dice);
    case EffectKind::swapped_channels:
      return draw_swapped_channels(experiment, dice);
    default:
      throw std::logic_error("draw_effect: unknown kind");
  }
}

}  // namespace reeve::testing
