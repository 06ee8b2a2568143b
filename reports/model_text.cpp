#include "reports/model_text.hpp"

#include <fmt/format.h>

#include <vector>

namespace reeve::reports {
namespace {

void add_note(const char* parts, double mu, const MuRange& range, std::vector<std::string>& notes) {
  if (range.low <= mu && mu <= range.high) return;
  notes.push_back(fmt::format(
      "the nominal friction coefficient of {}, {:.4g}, is outside its range, {:.4g} "
      "to {:.4g}, which is widened to hold it: [uncertainty] of the hardware file gives "
      "another",
      parts, mu, range.low, range.high));
}

Json subject_json(const Effect& effect) {
  const Subject& subject = effect.subject;
  switch (effect.cause->subject_kind()) {
    case SubjectKind::rig:
      return Json::object();
    case SubjectKind::channel:
      return {{"channel", segment_name(*subject.channel)}};
    case SubjectKind::channels:
      return {{"channel", segment_name(*subject.channel)},
              {"other_channel", segment_name(*subject.other_channel)}};
    case SubjectKind::finger:
      return {{"finger", subject.finger}};
    case SubjectKind::grasp:
      return {{"routing", subject.routing},
              {"recorded", held_fingers(*subject.recorded)},
              {"actual", held_fingers(*subject.actual)}};
    case SubjectKind::contact:
      return {{"routing", subject.routing}, {"contact", subject.contact}};
  }
  return Json::object();
}

Json effect_json(const Effect& effect, const Hardware& hardware) {
  Json json{{"cause", effect.cause->name()}, {"subject", subject_json(effect)}};
  json["values"] = Json::object();
  const std::vector<Parameter> parameters = effect.cause->parameters(hardware);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    json["values"][parameters[i].name] = number(effect.values[i]);
  }
  json["in_designs"] = belongs_to_designs(effect);
  return json;
}

// "sensor_gain[T3] (gain 1.08)"
std::string effect_text(const Effect& effect, const Hardware& hardware) {
  std::string values;
  const std::vector<Parameter> parameters = effect.cause->parameters(hardware);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    values += fmt::format("{}{} {:.4g}", i > 0 ? ", " : "", parameters[i].name, effect.values[i]);
  }
  return effect_name(effect) + (values.empty() ? "" : " (" + values + ")");
}

std::string list(const Model& model, bool in_designs) {
  std::string text;
  for (const Effect& effect : model.effects) {
    if (belongs_to_designs(effect) != in_designs) continue;
    text += (text.empty() ? "" : ", ") + effect_text(effect, model.hardware);
  }
  return text;
}

std::string absent_finger_note(const std::string& what, int finger) {
  return fmt::format("{} changes nothing: no routing here has a finger {}", what, finger);
}

}  // namespace

std::vector<std::string> range_notes(const Hardware& nominal, const UncertaintyRanges& ranges) {
  std::vector<std::string> notes;
  add_note("tubes", nominal.tube.mu, ranges.tube_mu, notes);
  add_note("sheaths", nominal.sheath.mu, ranges.sheath_mu, notes);
  return notes;
}

Json model_json(const Model& model, std::uint64_t unconverged) {
  if (model.effects.empty()) return nullptr;
  Json json;
  json["effects"] = list_json(
      model.effects, [&](const Effect& effect) { return effect_json(effect, model.hardware); });
  for (const ConditionRow& row : condition_table()) {
    json["conditions"][row.name] = number(model.conditions.*row.value);
  }
  json["unconverged"] = unconverged;
  return json;
}

std::vector<DocumentLine> model_lines(const Model& model, std::uint64_t unconverged) {
  if (model.effects.empty()) return {};
  const std::string effects = list(model, true);
  std::string text = "Model with " + (effects.empty() ? "no effect on designs" : effects) + ", at";
  for (const ConditionRow& row : condition_table()) {
    text += fmt::format("{} {} {:.6g}", row.name == condition_table()[0].name ? "" : ",", row.name,
                        model.conditions.*row.value);
  }
  std::vector<DocumentLine> lines{{text}};
  const std::string left_out = list(model, false);
  if (!left_out.empty()) {
    lines.push_back(
        {"Left out, since they are of the rig's motor, sensors and records and not of a design: " +
         left_out});
  }
  if (unconverged > 0) {
    lines.push_back({fmt::format("Note: friction takes nearly all of some tension; {} tension "
                                 "solve{} did not converge, and the figures are approximate",
                                 unconverged, unconverged == 1 ? "" : "s"),
                     true});
  }
  return lines;
}

std::vector<std::string> absent_finger_notes(const Model& model, int fingers) {
  std::vector<std::string> notes;
  for (const FingerHardware& finger : model.hardware.fingers) {
    if (finger.finger <= fingers) continue;
    notes.push_back(absent_finger_note(fmt::format("[finger.{}] of the hardware", finger.finger),
                                       finger.finger));
  }
  for (const Effect& effect : model.effects) {
    if (effect.cause->subject_kind() != SubjectKind::finger) continue;
    if (effect.subject.finger <= fingers) continue;
    notes.push_back(
        absent_finger_note(effect_name(effect) + " of the model", effect.subject.finger));
  }
  return notes;
}

std::vector<DocumentLine> absent_finger_lines(const Model& model, int fingers) {
  std::vector<DocumentLine> lines;
  for (const std::string& note : absent_finger_notes(model, fingers)) {
    lines.push_back({"Note: " + note, true});
  }
  return lines;
}

}  // namespace reeve::reports
