#include "tests/support/planting_alias.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "tests/support/planting_walk.hpp"

namespace reeve::testing {
namespace {

// ---- rows ----

using Adjust = std::function<void(ExperimentRow&)>;

double motor_tension(Dice& dice) { return std::round(dice.log_real(10, 60) * 100) / 100; }

void add_runs(const std::string& name, int runs, const std::vector<std::string>& words,
              const Adjust& adjust, Dice& dice, Experiment& experiment) {
  for (int run = 1; run <= runs; ++run) {
    for (int i = 0; i < 18; ++i) {
      ExperimentRow row;
      row.run = name + " " + std::to_string(run);
      row.condition.word = words[static_cast<std::size_t>(i) % words.size()];
      row.condition.motor_tension_N = motor_tension(dice);
      const std::set<int> fingers = fingers_of(row.condition.word);
      const int held = dice.integer(0, static_cast<int>(fingers.size()));
      if (fingers.size() > 1 && held > 0) row.condition.held = {held};
      row.measured = sensors_of(row.condition.word, false);
      adjust(row);
      experiment.rows.push_back(row);
    }
  }
  experiment.channels = channels_of(experiment.rows);
}

struct TwoExperiments {
  Experiment aliased, separated;
};

constexpr int first_runs = 10;
constexpr int further_runs = 6;

TwoExperiments two_experiments(const std::vector<std::string>& words, const Adjust& adjust,
                               const std::vector<std::string>& further_words,
                               const Adjust& further_adjust, Dice& dice) {
  TwoExperiments two;
  add_runs("run", first_runs, words, adjust, dice, two.aliased);
  two.separated = two.aliased;
  add_runs("further run", further_runs, further_words, further_adjust, dice, two.separated);
  return two;
}

const std::vector<std::string>& usual_words() {
  static const std::vector<std::string> words{"M-1-T-2-M", "F-1-P-2-F", "M-1-T-2-F"};
  return words;
}

void as_it_is(ExperimentRow& /*row*/) {}

// ---- kinds ----

struct AliasPlan {
  TwoExperiments experiments;
  std::array<PlantedEffect, 2> effects;
};

double whole_number(double low, double high, Dice& dice) {
  return std::round(dice.real(low, high));
}

PlantedEffect large(EffectKind kind, const Experiment& experiment, Dice& dice) {
  return draw_effect(kind, EffectSize::large, experiment, dice);
}

AliasPlan speed_or_temperature(Dice& dice) {
  const double speed = whole_number(40, 100, dice), temperature = whole_number(36, 40, dice);
  const Adjust one = [=](ExperimentRow& row) {
    row.condition.speed_mm_s = speed;
    row.condition.temperature_C = temperature;
  };
  const Adjust many = [&dice](ExperimentRow& row) {
    row.condition.speed_mm_s = std::round(dice.log_real(1, 100) * 10) / 10;
    row.condition.temperature_C = whole_number(10, 40, dice);
  };
  AliasPlan plan{two_experiments(usual_words(), one, usual_words(), many, dice), {}};
  // Sizes for which the other cause would be of a plausible size too.
  plan.effects = {draw_effect(EffectKind::speed_dependent_friction, EffectSize::medium,
                              plan.experiments.aliased, dice),
                  large(EffectKind::temperature, plan.experiments.aliased, dice)};
  return plan;
}

AliasPlan temperature_or_wear(Dice& dice) {
  const double cycle = whole_number(800, 3000, dice), temperature = whole_number(36, 40, dice);
  const Adjust one = [=](ExperimentRow& row) {
    row.condition.cycle = cycle;
    row.condition.temperature_C = temperature;
  };
  const Adjust many = [&dice, cycle](ExperimentRow& row) {
    row.condition.cycle = cycle + whole_number(0, 50, dice);
    row.condition.temperature_C = whole_number(10, 40, dice);
  };
  AliasPlan plan{two_experiments(usual_words(), one, usual_words(), many, dice), {}};
  plan.effects = {large(EffectKind::temperature, plan.experiments.aliased, dice),
                  draw_effect(EffectKind::wear, EffectSize::small, plan.experiments.aliased, dice)};
  return plan;
}

AliasPlan sheath_friction_or_angle(Dice& dice) {
  AliasPlan plan{two_experiments({"M-1-T-2-F", "M-1-F", "M-1-M"}, as_it_is,
                                 {"M-1-T-2-M", "F-1-P-2-F", "F-1-T-2-M"}, as_it_is, dice),
                 {}};
  plan.effects = {large(EffectKind::sheath_friction, plan.experiments.aliased, dice),
                  large(EffectKind::sheath_angle, plan.experiments.aliased, dice)};
  return plan;
}

PlantedEffect on_channel(EffectKind kind, const std::string& channel, Dice& dice) {
  Experiment only;
  only.channels = {channel};
  return large(kind, only, dice);
}

AliasPlan gain_or_offset(Dice& dice) {
  const double motor_N = whole_number(25, 50, dice);
  const auto leave_out = [](ExperimentRow& row) { std::erase(row.measured, "T2"); };
  // T2 is read in M-1-F only, where both fingers of other routings cannot disturb it.
  const Adjust one = [=](ExperimentRow& row) {
    if (row.condition.word == "M-1-F") {
      row.condition.motor_tension_N = motor_N;
    } else {
      leave_out(row);
    }
  };
  std::vector<std::string> words = usual_words();
  words.emplace_back("M-1-F");
  AliasPlan plan{two_experiments(words, one, words, as_it_is, dice), {}};
  plan.effects = {on_channel(EffectKind::sensor_gain, "T2", dice),
                  on_channel(EffectKind::sensor_offset, "T2", dice)};
  return plan;
}

AliasPlan tube_friction_or_gain(Dice& dice) {
  const Adjust release = [](ExperimentRow& row) {
    row.condition.direction = ReferenceDirection::release;
  };
  AliasPlan plan{two_experiments({"M-1-F"}, as_it_is, {"M-1-F"}, release, dice), {}};
  plan.effects = {large(EffectKind::tube_friction, plan.experiments.aliased, dice),
                  on_channel(EffectKind::sensor_gain, "T2", dice)};
  return plan;
}

AliasPlan plan_of(AliasKind kind, Dice& dice) {
  switch (kind) {
    case AliasKind::speed_or_temperature:
      return speed_or_temperature(dice);
    case AliasKind::temperature_or_wear:
      return temperature_or_wear(dice);
    case AliasKind::sheath_friction_or_angle:
      return sheath_friction_or_angle(dice);
    case AliasKind::gain_or_offset:
      return gain_or_offset(dice);
    default:
      return tube_friction_or_gain(dice);
  }
}

}  // namespace

const char* alias_name(AliasKind kind) {
  constexpr std::array names{"speed_or_temperature", "temperature_or_wear",
                             "sheath_friction_or_angle", "gain_or_offset", "tube_friction_or_gain"};
  return names[static_cast<std::size_t>(kind)];
}

const std::vector<AliasKind>& alias_kinds() {
  static const std::vector<AliasKind> kinds{
      AliasKind::speed_or_temperature, AliasKind::temperature_or_wear,
      AliasKind::sheath_friction_or_angle, AliasKind::gain_or_offset,
      AliasKind::tube_friction_or_gain};
  return kinds;
}

PlantedAlias plant_alias(AliasKind kind, const NoiseLevel& noise, std::uint64_t seed) {
  Dice dice(seed);
  AliasPlan plan = plan_of(kind, dice);
  if (dice.chance(0.5)) std::swap(plan.effects[0], plan.effects[1]);
  const std::vector<PlantedEffect> truth{plan.effects[0]};
  return {{plan.effects[0].name, plan.effects[1].name},
          measure(plan.experiments.aliased, truth, noise, seed),
          measure(plan.experiments.separated, truth, noise, seed)};
}

}  // namespace reeve::testing
