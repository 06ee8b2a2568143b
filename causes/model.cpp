#include "causes/model.hpp"

#include <algorithm>
#include <utility>

#include "causes/library.hpp"

namespace reeve {
namespace {

std::ptrdiff_t place(const Cause* cause) {
  const auto causes = cause_library();
  return std::find(causes.begin(), causes.end(), cause) - causes.begin();
}

}  // namespace

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

bool reaches(const Model& model, Reach reach) {
  return std::any_of(model.effects.begin(), model.effects.end(),
                     [&](const Effect& effect) { return effect.cause->reach() == reach; });
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

double reading(const Model& model, const Segment& segment, double tension_N) {
  for (const Effect& effect : model.effects) {
    if (effect.cause->reach() == Reach::reading) {
      tension_N = effect.cause->reading(tension_N, segment, effect);
    }
  }
  return tension_N;
}

}  // namespace reeve
