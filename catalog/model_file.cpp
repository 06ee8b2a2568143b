#include "catalog/model_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "catalog/hardware_tables.hpp"
#include "catalog/law_tables.hpp"
#include "catalog/toml_node.hpp"
#include "causes/library.hpp"
#include "causes/term.hpp"
#include "core/contact_name.hpp"
#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/notation.hpp"

namespace reeve::catalog {
namespace {

// The [[effect]] tables of a model file. Nothing here knows a cause by name: what a table must hold
// follows from the cause's parameters and from the kind of its subject.

std::vector<std::string_view> subject_keys(SubjectKind kind) {
  switch (kind) {
    case SubjectKind::rig:
      return {};
    case SubjectKind::channel:
      return {"channel"};
    case SubjectKind::channels:
      return {"channel", "other_channel"};
    case SubjectKind::finger:
      return {"finger"};
    case SubjectKind::grasp:
      return {"routing", "recorded", "actual"};
    case SubjectKind::contact:
      return {"routing", "contact"};
  }
  return {};
}

// Returns parse(text at this key); an error gets the place in the file.
template <typename Parse>
auto parsed(const TomlNode& table, std::string_view key, std::string_view expected, Parse parse) {
  const TomlNode& node = table.require(key, expected);
  const std::string& text = node.text();
  try {
    return parse(text);
  } catch (const InputError& error) {
    node.fail_at_value(error.at(node.name).fault());
  }
}

Segment read_channel(const TomlNode& table, std::string_view key) {
  constexpr std::string_view expected =
      "a strand (T1), a motor-side segment (a) or a stretch at the hand (h1), in quotes";
  const TomlNode& node = table.require(key, expected);
  if (const auto channel = segment_named(node.text())) return *channel;
  node.fail_expected(expected);
}

Routing read_routing(const TomlNode& table, const Catalogue& catalogue) {
  return parsed(table, "routing",
                "the word of a routing in quotes, such as \"M-1-T-2-F\", or its catalogue name",
                [&](const std::string& text) {
                  const Routing* named = catalogue.find_routing(text);
                  return named != nullptr ? *named : parse_routing(text);
                });
}

Grasp read_grasp(const TomlNode& table, std::string_view key, int fingers) {
  return parsed(table, key, "held fingers in quotes, such as \"none\" or \"1,2\"",
                [&](const std::string& text) { return parse_grasp(text, fingers); });
}

std::string read_contact(const TomlNode& table, const Network& network) {
  const TomlNode& node =
      table.require("contact", "a contact of the routing in quotes, such as \"T1-T2\"");
  if (const auto contact = find_contact(network, node.text())) {
    return contact_name(network, *contact);
  }
  std::string names;
  for (std::size_t k = 0; k < network.contacts.size(); ++k) {
    names += (k > 0 ? ", " : "") + contact_name(network, k);
  }
  node.fail_expected("one of " + names);
}

void read_two_grasps(const TomlNode& table, int fingers, Subject& subject) {
  subject.recorded = read_grasp(table, "recorded", fingers);
  subject.actual = read_grasp(table, "actual", fingers);
  if (subject.recorded == subject.actual) {
    table.find("actual")->fail_expected("another grasp than 'recorded'");
  }
}

Subject read_subject(const TomlNode& table, SubjectKind kind, const Catalogue& catalogue) {
  Subject subject;
  const bool of_two = kind == SubjectKind::channels;
  if (of_two || kind == SubjectKind::channel) subject.channel = read_channel(table, "channel");
  if (of_two) {
    subject.other_channel = read_channel(table, "other_channel");
    if (subject.other_channel == subject.channel) {
      table.find("other_channel")->fail_expected("another one than 'channel'");
    }
  }
  if (kind == SubjectKind::finger) {
    subject.finger = table.require("finger", "the number of a finger").integer(1, max_fingers);
  }
  if (kind == SubjectKind::grasp || kind == SubjectKind::contact) {
    const Routing routing = read_routing(table, catalogue);
    subject.routing = to_word(routing);
    if (kind == SubjectKind::grasp) read_two_grasps(table, finger_count(routing), subject);
    if (kind == SubjectKind::contact) subject.contact = read_contact(table, expand(routing));
  }
  return subject;
}

double read_parameter(const TomlNode& table, const Parameter& parameter) {
  const auto [low, high] = valid_range(parameter);
  const std::string_view unit = parameter.unit;
  return table
      .require(parameter.name, fmt::format("a number from {} to {}{}", low, high,
                                           unit == "1" ? "" : fmt::format(" {}", unit)))
      .number_between(low, high);
}

void add_new(const TomlNode& table, const Effect& effect, Model& model) {
  for (const Effect& other : model.effects) {
    if (!is_about_the_same(effect, other)) continue;
    table.fail_at_key(
        {.what = fmt::format("{}: {} is given twice", table.name, effect_name(effect)),
         .expected = "each effect once"});
  }
  add_effect(model, effect);
}

std::string line(std::string_view key, const std::string& text) {
  return fmt::format("{} = \"{}\"\n", key, text);
}

// Adds the effect to the model, whose hardware must be read already. A routing is a word or a name
// of the catalogue.
void read_effect(const TomlNode& table, const Catalogue& catalogue, Model& model) {
  const std::string known = "one of " + cause_names();
  const TomlNode& cause = table.require("cause", known);
  Effect effect;
  effect.cause = find_cause(cause.text());
  if (effect.cause == nullptr)
    cause.fail_expected(known + did_you_mean(cause.text(), cause_list()));
  const SubjectKind kind = effect.cause->subject_kind();
  const std::vector<Parameter> parameters = effect.cause->parameters(model.hardware);
  std::vector<std::string_view> keys = subject_keys(kind);
  keys.insert(keys.begin(), "cause");
  for (const Parameter& parameter : parameters) keys.emplace_back(parameter.name);
  table.allow_only(keys);
  effect.subject = read_subject(table, kind, catalogue);
  for (const Parameter& parameter : parameters) {
    effect.values.push_back(read_parameter(table, parameter));
  }
  add_new(table, effect, model);
  validate_at(table, effective_hardware(model));
}

std::string effect_toml(const Effect& effect, const Hardware& hardware) {
  const Subject& subject = effect.subject;
  const SubjectKind kind = effect.cause->subject_kind();
  std::string text = "\n[[effect]]\n" + line("cause", effect.cause->name());
  if (subject.channel) text += line("channel", segment_name(*subject.channel));
  if (subject.other_channel) text += line("other_channel", segment_name(*subject.other_channel));
  if (kind == SubjectKind::finger) text += fmt::format("finger = {}\n", subject.finger);
  if (kind == SubjectKind::grasp || kind == SubjectKind::contact) {
    text += line("routing", subject.routing);
  }
  if (kind == SubjectKind::grasp) {
    text += line("recorded", to_text(*subject.recorded)) + line("actual", to_text(*subject.actual));
  }
  if (kind == SubjectKind::contact) text += line("contact", subject.contact);
  const std::vector<Parameter> parameters = effect.cause->parameters(hardware);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    text += fmt::format("{} = {}\n", parameters[i].name, effect.values[i]);
  }
  return text;
}

// The columns that the laws ask for, in their order.
std::vector<std::string> columns_of_laws(const Model& model) {
  std::vector<std::string> columns;
  for (const Effect& effect : model.effects) {
    for (const Covariate& covariate : covariates(effect)) {
      const std::string name = covariate_name(covariate);
      const bool is_new = std::ranges::find(columns, name) == columns.end();
      if (covariate.kind == CovariateKind::column && is_new) columns.push_back(name);
    }
  }
  return columns;
}

// After the effects: a further column is one that a law asks for.
Conditions read_conditions(const TomlNode& file, const Model& model) {
  Conditions conditions;
  const TomlNode* node = file.find("conditions");
  if (node == nullptr) return conditions;
  const std::vector<std::string> columns = columns_of_laws(model);
  std::vector<std::string_view> keys;
  for (const ConditionRow& row : condition_table()) keys.emplace_back(row.name);
  keys.insert(keys.end(), columns.begin(), columns.end());
  node->table().allow_only(keys);
  for (const ConditionRow& row : condition_table()) {
    const TomlNode* value = node->find(row.name);
    if (value != nullptr)
      conditions.*row.value = value->number_between(row.range.low, row.range.high);
  }
  Record record;
  for (const std::string& column : columns) {
    const TomlNode* value = node->find(column);
    if (value == nullptr) continue;
    record.columns.push_back({covariate_named(column).column, value->finite_number()});
  }
  if (!record.columns.empty()) conditions.record = std::make_shared<const Record>(record);
  return conditions;
}

std::string conditions_toml(const Model& model) {
  const Conditions& conditions = model.conditions;
  std::string text = "\n[conditions]\n";
  for (const ConditionRow& row : condition_table()) {
    text += fmt::format("{} = {}\n", row.name, conditions.*row.value);
  }
  if (!conditions.record) return text;
  for (const std::string& column : columns_of_laws(model)) {
    for (const NamedValue& value : conditions.record->columns) {
      if (value.name != covariate_named(column).column) continue;
      text += fmt::format("{} = {}\n", toml_text(column), value.value);
    }
  }
  return text;
}

}  // namespace

std::vector<Effect> read_terms_file(const std::filesystem::path& path, const Catalogue& catalogue) {
  const TomlNode file = read_toml(path);
  file.allow_only({"law"});
  Model laws;
  for (const TomlNode& law : file.require("law", "one [[law]] at least").tables()) {
    add_new(law, read_law(law, catalogue), laws);
  }
  return laws.effects;
}

ModelFile read_model_file(const std::filesystem::path& path, const Catalogue& catalogue) {
  const TomlNode file = read_toml(path);
  std::vector<std::string_view> names = hardware_table_names();
  names.insert(names.end(), {"conditions", "effect", "law"});
  file.allow_only(names);
  const HardwareFile hardware = read_hardware_tables(file);
  ModelFile result{{hardware.hardware}, hardware.uncertainty, hardware.vary};
  if (const TomlNode* effects = file.find("effect")) {
    for (const TomlNode& effect : effects->tables()) read_effect(effect, catalogue, result.model);
  }
  if (const TomlNode* laws = file.find("law")) {
    for (const TomlNode& law : laws->tables()) add_new(law, read_law(law, catalogue), result.model);
  }
  result.model.conditions = read_conditions(file, result.model);
  result.model.hardware.origin = origin_of(file);
  return result;
}

std::string model_toml(const Model& model, const std::vector<std::string>& comment_lines,
                       const UncertaintyRanges& uncertainty) {
  std::string text;
  for (const std::string& line : comment_lines) text += toml_comment(line);
  text += hardware_toml(model.hardware, uncertainty) + conditions_toml(model);
  for (const Effect& effect : model.effects) {
    const bool is_law = term_of(*effect.cause) != nullptr;
    text += is_law ? law_toml(effect) : effect_toml(effect, model.hardware);
  }
  return text;
}

}  // namespace reeve::catalog
