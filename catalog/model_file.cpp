#include "catalog/model_file.hpp"

#include <fmt/format.h>

#include "catalog/effect_tables.hpp"
#include "catalog/hardware_tables.hpp"

namespace reeve::catalog {
namespace {

Conditions read_conditions(const TomlNode& file) {
  Conditions conditions;
  const TomlNode* node = file.find("conditions");
  if (node == nullptr) return conditions;
  std::vector<std::string_view> keys;
  for (const ConditionRow& row : condition_table()) keys.emplace_back(row.name);
  node->table().allow_only(keys);
  for (const ConditionRow& row : condition_table()) {
    const TomlNode* value = node->find(row.name);
    if (value != nullptr)
      conditions.*row.value = value->number_between(row.range.low, row.range.high);
  }
  return conditions;
}

std::string conditions_toml(const Conditions& conditions) {
  std::string text = "\n[conditions]\n";
  for (const ConditionRow& row : condition_table()) {
    text += fmt::format("{} = {}\n", row.name, conditions.*row.value);
  }
  return text;
}

}  // namespace

ModelFile read_model_file(const std::filesystem::path& path, const Catalogue& catalogue) {
  const TomlNode file = read_toml(path);
  std::vector<std::string_view> names = hardware_table_names();
  names.insert(names.end(), {"conditions", "effect"});
  file.allow_only(names);
  const HardwareFile hardware = read_hardware_tables(file);
  ModelFile result{
      {hardware.hardware, {}, read_conditions(file)}, hardware.uncertainty, hardware.vary};
  if (const TomlNode* effects = file.find("effect")) {
    for (const TomlNode& effect : effects->tables()) read_effect(effect, catalogue, result.model);
  }
  result.model.hardware.origin = origin_of(file);
  return result;
}

std::string model_toml(const Model& model, const std::vector<std::string>& comment_lines,
                       const UncertaintyRanges& uncertainty) {
  std::string text;
  for (const std::string& line : comment_lines) text += toml_comment(line);
  text += hardware_toml(model.hardware, uncertainty) + conditions_toml(model.conditions);
  for (const Effect& effect : model.effects) text += effect_toml(effect, model.hardware);
  return text;
}

}  // namespace reeve::catalog
