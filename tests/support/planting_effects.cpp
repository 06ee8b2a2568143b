#include "tests/support/planting_effects.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "tests/support/planting_rig_effects.hpp"
#include "tests/support/planting_seizure.hpp"
#include "tests/support/planting_walk.hpp"

namespace reeve::testing {
namespace {

using Sizes = std::array<double, 3>;

double pick(const Sizes& sizes, EffectSize size) { return sizes[static_cast<std::size_t>(size)]; }

double either_sign(double value, Dice& dice) { return dice.chance(0.5) ? value : -value; }

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

PlantedEffect draw_sensor_gain(EffectSize size, const Experiment& experiment, Dice& dice) {
  const std::string channel = draw_channel(experiment, dice);
  const double gain = 1 + either_sign(pick({0.03, 0.06, 0.12}, size), dice);
  return {
      EffectKind::sensor_gain, "sensor_gain[" + channel + "]", {{"gain", gain}}, [=](Truth& truth) {
        truth.sensors.gain[channel] = gain;
      }};
}

PlantedEffect draw_sensor_offset(EffectSize size, const Experiment& experiment, Dice& dice) {
  const std::string channel = draw_channel(experiment, dice);
  const double offset = either_sign(pick({0.1, 0.3, 0.6}, size), dice);
  return {EffectKind::sensor_offset,
          "sensor_offset[" + channel + "]",
          {{"offset", offset}},
          [=](Truth& truth) { truth.sensors.offset_N[channel] = offset; }};
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

PlantedEffect draw_drawn(EffectKind kind, EffectSize size, const Experiment& experiment,
                         Dice& dice) {
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
    default:
      throw std::logic_error("draw_effect: unknown kind");
  }
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
  static const std::vector<EffectKind> kinds = [] {
    std::vector<EffectKind> all;
    for (int i = 0; i <= static_cast<int>(EffectKind::seized_contact); ++i) {
      all.push_back(static_cast<EffectKind>(i));
    }
    return all;
  }();
  return kinds;
}

const std::vector<EffectKind>& unknown_effects() {
  static const std::vector<EffectKind> kinds{EffectKind::crosstalk, EffectKind::drift,
                                             EffectKind::wave};
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
  const auto of = [size](const Sizes& sizes) { return pick(sizes, size); };
  switch (kind) {
    case EffectKind::tube_friction:
      return one_number(kind, "mu", of({0.15, 0.12, 0.09}),
                        [](Truth& t) -> double& { return t.nature.tube_mu; });
    case EffectKind::sheath_friction:
      return one_number(kind, "mu", of({0.165, 0.15, 0.12}),
                        [](Truth& t) -> double& { return t.nature.sheath_mu; });
    case EffectKind::bearing_friction:
      return one_number(kind, "mu", of({0.02, 0.05, 0.1}),
                        [](Truth& t) -> double& { return t.nature.bearing_mu; });
    case EffectKind::load_dependent_friction:
      return one_number(kind, "exponent", of({0.05, 0.1, 0.2}),
                        [](Truth& t) -> double& { return t.nature.load_exponent; });
    case EffectKind::speed_dependent_friction:
      return one_number(kind, "slope", of({0.03, 0.06, 0.12}),
                        [](Truth& t) -> double& { return t.nature.speed_slope; });
    case EffectKind::temperature:
      return one_number(kind, "slope", of({0.002, 0.004, 0.008}),
                        [](Truth& t) -> double& { return t.nature.temperature_slope_per_K; });
    case EffectKind::bending_stiffness:
      return one_number(kind, "force", of({0.1, 0.3, 0.6}),
                        [](Truth& t) -> double& { return t.nature.bending_force_N; });
    case EffectKind::bearing_drag:
      return one_number(kind, "force", of({0.1, 0.3, 0.6}),
                        [](Truth& t) -> double& { return t.nature.drag_force_N; });
    case EffectKind::pretension:
      return one_number(kind, "force", of({0.1, 0.3, 0.6}),
                        [](Truth& t) -> double& { return t.sensors.pretension_N; });
    case EffectKind::crosstalk:
      return one_number(kind, "share", of({0.05, 0.1, 0.2}),
                        [](Truth& t) -> double& { return t.sensors.crosstalk; });
    case EffectKind::drift:
      return one_number(kind, "drift", of({0.1, 0.2, 0.4}),
                        [](Truth& t) -> double& { return t.sensors.drift; });
    case EffectKind::wave:
      return one_number(kind, "amplitude", of({0.05, 0.1, 0.2}),
                        [](Truth& t) -> double& { return t.sensors.wave_amplitude; });
    default:
      break;
  }
  const auto& of_rigs = rig_effects();
  const bool of_rig = std::find(of_rigs.begin(), of_rigs.end(), kind) != of_rigs.end();
  return of_rig ? draw_rig_effect(kind, size, experiment, dice)
                : draw_drawn(kind, size, experiment, dice);
}

}  // namespace reeve::testing
