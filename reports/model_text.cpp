#include "reports/model_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "causes/term.hpp"
#include "core/idle_values.hpp"
#include "reports/assumed_words.hpp"
#include "reports/law_words.hpp"

namespace reeve::reports {
namespace {

void add_note(const char* parts, const ContactLaw& law, const MuRange& range,
              std::vector<std::string>& notes) {
  if (law.known || (range.low <= law.mu && law.mu <= range.high)) return;
  notes.push_back(fmt::format(
      "the nominal friction coefficient of {}, {:.4g}, is outside its range, {:.4g} "
      "to {:.4g}, which is widened to hold it: [uncertainty] of the hardware file gives "
      "another",
      parts, law.mu, range.low, range.high));
}

Json subject_json(const Effect& effect) {
  if (const Term* term = term_of(*effect.cause)) return law_json(*term);
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

// "sensor_gain[T3] (gain 1.08)", or a law's site and formula.
std::string effect_text(const Effect& effect, const Hardware& hardware) {
  if (const Term* term = term_of(*effect.cause)) return law_text(*term, effect.values);
  std::string values;
  const std::vector<Parameter> parameters = effect.cause->parameters(hardware);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    values += fmt::format("{}{} {:.4g}", i > 0 ? ", " : "", parameters[i].name, effect.values[i]);
  }
  return effect_name(effect) + (values.empty() ? "" : " (" + values + ")");
}

std::string list(const Model& model, bool in_designs) {
  std::vector<std::string> texts;
  for (const Effect& effect : model.effects) {
    if (belongs_to_designs(effect) != in_designs) continue;
    texts.push_back(effect_text(effect, model.hardware));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string absent_finger_note(const std::string& what, int finger) {
  return fmt::format("{} changes nothing: no routing here has a finger {}", what, finger);
}

// Notes on what is common to springs or to slack, if no tendon has any.
void add_unused(const TendonParts& tendons, std::vector<std::string>& notes) {
  const auto add = [&](const char* common, const std::optional<double> TendonParts::*value,
                       const char* own, const std::optional<double> TendonHardware::*own_value) {
    const bool is_used = std::ranges::any_of(
        tendons.own, [&](const TendonHardware& tendon) { return (tendon.*own_value).has_value(); });
    if (is_used || !(tendons.*value)) return;
    notes.push_back(fmt::format(
        "{} in [tendon] of the hardware changes nothing: no tendon has a {}", common, own));
  };
  add("EA_N", &TendonParts::EA_N, "stiffness_N_mm", &TendonHardware::stiffness_N_mm);
  add("travel_mm", &TendonParts::travel_mm, "slack_mm", &TendonHardware::slack_mm);
}

struct Condition {
  std::string name;
  double value = 0;
};

// The columns that laws of designs ask for, each once, are among them; one that the model does not
// give is at the middle of its law.
std::vector<Condition> conditions_of(const Model& model) {
  std::vector<Condition> conditions;
  for (const ConditionRow& row : condition_table()) {
    conditions.push_back({row.name, model.conditions.*row.value});
  }
  for (const Effect& effect : model.effects) {
    if (!belongs_to_designs(effect)) continue;
    for (const Covariate& x : covariates(effect)) {
      if (x.kind != CovariateKind::column) continue;
      const std::string name = covariate_name(x);
      const bool is_new = std::ranges::none_of(
          conditions, [&](const Condition& other) { return other.name == name; });
      if (is_new) conditions.push_back({name, covariate_value(x, model.conditions, 0)});
    }
  }
  return conditions;
}

// Designs carry up to the motor tension, so that of loads only the upper end is passed.
bool lies_outside(const Covariate& x, const Conditions& conditions) {
  const double value = covariate_value(x, conditions, conditions.motor_tension_N);
  return value > x.seen.high || (value < x.seen.low && x.kind != CovariateKind::load);
}

std::string outside_note(const Covariate& x, const Conditions& conditions) {
  return fmt::format(
      "{} {} {:.6g} lies outside {:.6g} to {:.6g}, where the law was seen: it is held "
      "constant there",
      covariate_name(x), x.kind == CovariateKind::load ? "up to" : "=",
      covariate_value(x, conditions, conditions.motor_tension_N), x.seen.low, x.seen.high);
}

// One for each covariate of a law whose condition lies outside the range seen.
std::vector<std::string> outside_notes(const Model& model) {
  std::vector<std::string> notes;
  for (const Effect& effect : model.effects) {
    if (!belongs_to_designs(effect)) continue;
    for (const Covariate& x : covariates(effect)) {
      if (!lies_outside(x, model.conditions)) continue;
      const std::string note = outside_note(x, model.conditions);
      if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
    }
  }
  return notes;
}

int finger_of(const Effect& effect) {
  const Term* term = term_of(*effect.cause);
  return term != nullptr ? term->site.finger : effect.subject.finger;
}

}  // namespace

std::vector<std::string> range_notes(const Hardware& nominal, const UncertaintyRanges& ranges) {
  std::vector<std::string> notes;
  add_note("tubes", nominal.tube, ranges.tube_mu, notes);
  add_note("sheaths", nominal.sheath, ranges.sheath_mu, notes);
  return notes;
}

std::vector<std::string> undrawn_notes(const Hardware& nominal, const LookAtNetworks& look) {
  std::vector<ContactKind> drawn;
  if (!nominal.tube.known) drawn.push_back(ContactKind::tube);
  if (!nominal.sheath.known) drawn.push_back(ContactKind::sheath);
  if (!nominal.bearing.known) append(drawn, std::vector{ContactKind::bearing, ContactKind::block});
  ValueUse use(nominal, drawn, LawValue::mu);
  look(use);
  if (!use.has_owners()) return {};
  return {
      fmt::format("{} have friction coefficients of their own, which are not drawn", use.owners())};
}

Json model_json(const Model& model, std::uint64_t unconverged) {
  if (model.effects.empty()) return nullptr;
  Json json;
  json["effects"] = list_json(
      model.effects, [&](const Effect& effect) { return effect_json(effect, model.hardware); });
  for (const Condition& condition : conditions_of(model)) {
    json["conditions"][condition.name] = number(condition.value);
  }
  json["outside_range"] = outside_notes(model);
  json["unconverged"] = unconverged;
  return json;
}

std::vector<DocumentLine> model_lines(const Model& model, std::uint64_t unconverged) {
  if (model.effects.empty()) return {};
  const std::string effects = list(model, true);
  const std::string text =
      "Model with " + (effects.empty() ? "no effect on designs" : effects) + ", at ";
  const auto of_one = [](const Condition& condition) {
    return fmt::format("{} {:.6g}", condition.name, condition.value);
  };
  std::vector<DocumentLine> lines{{text + joined(conditions_of(model), ", ", of_one)}};
  append(lines, note_lines(outside_notes(model)));
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

std::vector<std::string> model_notes(const Model& model, int fingers) {
  std::vector<std::string> notes = angle_notes(model.hardware);
  add_unused(model.hardware.tendon, notes);
  const ContactLaw& sheath = model.hardware.sheath;
  if (sheath.length_mm && sheath.wobble_rad_per_m == 0) {
    notes.push_back(
        fmt::format("the sheath length of {:.6g} mm has no effect: capstan friction "
                    "depends on the sum of the bends, not on the length",
                    *sheath.length_mm));
  }
  for (const FingerHardware& finger : model.hardware.fingers) {
    if (finger.finger <= fingers) continue;
    notes.push_back(absent_finger_note(fmt::format("[finger.{}] of the hardware", finger.finger),
                                       finger.finger));
  }
  for (const Effect& effect : model.effects) {
    if (finger_of(effect) <= fingers) continue;
    notes.push_back(absent_finger_note(effect_name(effect) + " of the model", finger_of(effect)));
  }
  return notes;
}

std::vector<std::string> model_notes(const Model& model, const std::vector<Network>& networks) {
  const int fingers = networks.front().fingers;
  std::vector<std::string> notes = model_notes(model, fingers);
  IdleValues idle(model.hardware, fingers);
  for (const Network& network : networks) idle.look_at(network);
  const std::vector<std::string> keys = idle.keys();
  if (keys.empty()) return notes;
  notes.push_back(fmt::format("{} of the hardware {} nothing: no contact here takes {}",
                              fmt::join(keys, ", "), keys.size() == 1 ? "changes" : "change",
                              keys.size() == 1 ? "it" : "them"));
  return notes;
}

std::vector<DocumentLine> note_lines(const std::vector<std::string>& notes) {
  std::vector<DocumentLine> lines;
  for (const std::string& note : notes) lines.push_back({"Note: " + note, true});
  return lines;
}

}  // namespace reeve::reports
