#include "causes/model.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "causes/library.hpp"
#include "causes/term.hpp"
#include "core/error.hpp"

namespace reeve::causes {
namespace {

// A law of gain acts before one of offset, as the library's sensors do: T (1 + f) + g.
std::ptrdiff_t place(const Cause* cause) {
  const auto causes = cause_library();
  const Term* law = term_of(*cause);
  return std::ranges::find(causes, cause) - causes.begin() +
         (law == nullptr ? 0 : static_cast<std::ptrdiff_t>(law->target));
}

}  // namespace

std::span<const ConditionRow> condition_table() {
  static const std::array<ConditionRow, 4> table{
      {{"motor_tension_N", "N", &Conditions::motor_tension_N, {0.01, 1e5}},
       {"speed_mm_s", "mm/s", &Conditions::speed_mm_s, {0.01, 1e5}},
       {"cycle", "1", &Conditions::cycle, {0, 1e9}},
       {"temperature_C", "C", &Conditions::temperature_C, {-100, 300}}}};
  return table;
}

void add_effect(Model& model, Effect effect) {
  const auto at = std::upper_bound(
      model.effects.begin(), model.effects.end(), effect,
      [](const Effect& a, const Effect& b) { return place(a.cause) < place(b.cause); });
  model.effects.insert(at, std::move(effect));
}

Hardware effective_hardware(Hardware hardware, const std::vector<Effect>& effects) {
  for (const Effect& effect : effects) {
    if (effect.cause->reach() == Reach::hardware) effect.cause->change_hardware(hardware, effect);
  }
  return hardware;
}

Hardware effective_hardware(const Model& model) {
  return effective_hardware(model.hardware, model.effects);
}

Hardware possible_hardware(const Model& model) {
  validate(model.hardware);
  Hardware hardware = effective_hardware(model);
  if (const auto found = fault(hardware)) throw OutOfRange(sentence(*found));
  return hardware;
}

bool reaches(const Model& model, Reach reach) {
  return std::ranges::any_of(model.effects,
                             [&](const Effect& effect) { return effect.cause->reach() == reach; });
}

bool changes_exponents(const Model& model) {
  return reaches(model, Reach::exponent) || reaches(model, Reach::conditions) ||
         reaches(model, Reach::load);
}

bool names_routings(const Model& model) {
  return std::ranges::any_of(model.effects, [](const Effect& effect) {
    const Term* term = term_of(*effect.cause);
    return effect.cause->reach() == Reach::contact ||
           (term != nullptr && !term->site.routing.empty());
  });
}

bool treats_fingers_alike(const Model& model, int fingers) {
  return core::treats_fingers_alike(effective_hardware(model), fingers) &&
         std::ranges::none_of(model.effects, [&](const Effect& effect) {
           const Term* term = term_of(*effect.cause);
           return term != nullptr && term->site.finger != 0 && term->site.finger <= fingers;
         });
}

Grasp actual_grasp(const Model& model, const std::string& word, Grasp recorded) {
  Grasp grasp = recorded;
  for (const Effect& effect : model.effects) {
    if (effect.cause->reach() != Reach::grasp) continue;
    const Grasp actual = effect.cause->actual_grasp(word, recorded, effect);
    if (!(actual == recorded)) grasp = actual;
  }
  return grasp;
}

std::vector<std::size_t> seized_contacts(const Model& model, const std::string& word,
                                         const Network& network) {
  std::vector<std::size_t> contacts;
  for (const Effect& effect : model.effects) {
    if (effect.cause->reach() != Reach::contact) continue;
    if (const auto k = effect.cause->seized_contact(word, network, effect)) contacts.push_back(*k);
  }
  return contacts;
}

bool belongs_to_designs(const Effect& effect) {
  const Term* term = term_of(*effect.cause);
  if (term != nullptr && !(term->site.runs.empty() && term->site.group.empty())) return false;
  const Reach reach = effect.cause->reach();
  return reach != Reach::reading && reach != Reach::grasp && reach != Reach::motor;
}

Conditions at_tendon(const Model& model, Direction direction, const Conditions& recorded) {
  Conditions result = recorded;
  for (const Effect& effect : model.effects) {
    if (effect.cause->reach() != Reach::motor) continue;
    result.motor_tension_N =
        std::max(0.0, effect.cause->at_tendon(result.motor_tension_N, direction, recorded, effect));
  }
  return result;
}

void read(const Model& model, Direction direction, const Conditions& conditions,
          std::span<Sensor> sensors) {
  for (const Effect& effect : model.effects) {
    if (effect.cause->reach() != Reach::reading) continue;
    effect.cause->read(sensors, direction, conditions, effect);
  }
}

double reading(const Model& model, const Segment& segment, double tension_N) {
  std::array<Sensor, 1> alone{{{segment, tension_N}}};
  read(model, Direction::pull, {}, alone);
  return alone[0].reading_N;
}

bool reads_linearly(const Model& model) {
  return std::ranges::all_of(model.effects,
                             [](const Effect& effect) { return effect.cause->reads_linearly(); });
}

}  // namespace reeve::causes
