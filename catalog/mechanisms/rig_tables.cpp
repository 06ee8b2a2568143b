#include "catalog/mechanisms/rig_tables.hpp"

#include <algorithm>
#include <cctype>
#include <numbers>
#include <utility>

#include "catalog/hardware_tables.hpp"
#include "core/error.hpp"

namespace reeve::catalog {
namespace {

double read_value(const TomlNode& node, const NamedValues& names) {
  const Expression expression = read_expression(node);
  try {
    return expression.evaluate(names);
  } catch (const InputError& error) {
    node.fail_at_value(error.fault());
  }
}

// The same tables with numbers in place of expressions.
TomlNode with_numbers(TomlNode node, const NamedValues& names) {
  if (node.kind == TomlKind::string) {
    node.number = read_value(node, names);
    node.kind = TomlKind::floating;
  }
  for (TomlNode& child : node.children) child = with_numbers(std::move(child), names);
  return node;
}

// What `over` has, and what it has not of `base`.
TomlNode overlaid(TomlNode base, const TomlNode& over) {
  for (const TomlNode& child : over.children) {
    const auto same = std::find_if(base.children.begin(), base.children.end(),
                                   [&](const TomlNode& other) { return other.key == child.key; });
    if (same == base.children.end()) {
      base.children.push_back(child);
    } else if (same->kind == TomlKind::table && child.kind == TomlKind::table) {
      *same = overlaid(std::move(*same), child);
    } else {
      *same = child;
    }
  }
  return base;
}

Hardware read_own_hardware(const TomlNode& tables, const NamedValues& names) {
  tables.table().allow_only(hardware_table_names());
  return read_hardware_tables(with_numbers(tables, names)).hardware;
}

NamedValues read_let(const TomlNode* node) {
  NamedValues values{{"pi", std::numbers::pi}};
  if (node == nullptr) return values;
  for (const TomlNode& item : node->table().children) {
    const bool plain =
        std::all_of(
            item.key.begin(), item.key.end(),
            [](unsigned char c) { return (std::isalnum(c) != 0 && c < 0x80) || c == '_'; }) &&
        !item.key.empty() && std::isdigit(static_cast<unsigned char>(item.key[0])) == 0;
    if (!plain || values.contains(item.key)) {
      item.fail_at_key({.what = "let",
                        .value = item.key,
                        .expected = "a new name of letters, digits and '_', such as K or P1"});
    }
    values[item.key] = item.is_number() ? item.number : read_value(item, values);
  }
  return values;
}

}  // namespace

Expression read_expression(const TomlNode& node) {
  try {
    return parse_expression(node.text());
  } catch (const InputError& error) {
    node.fail_at_value(error.fault());
  }
}

std::vector<Rig> read_rigs(const TomlNode& file) {
  TomlNode own;
  own.file = file.file;
  own.name = "hardware";
  if (const TomlNode* hardware = file.find("hardware")) own = *hardware;
  std::vector<Rig> rigs{{"", "", read_let(nullptr), {}}};
  rigs[0].hardware = read_own_hardware(own, rigs[0].let);
  const TomlNode* others = file.find("rig");
  if (others == nullptr) return rigs;
  for (const TomlNode& node : others->table().children) {
    node.table().allow_only({"inferred_from", "let", "hardware"});
    Rig rig{node.key, "", read_let(node.find("let")), {}};
    if (const TomlNode* from = node.find("inferred_from")) rig.inferred_from = from->text();
    const TomlNode* hardware = node.find("hardware");
    rig.hardware = read_own_hardware(hardware == nullptr ? own : overlaid(own, *hardware), rig.let);
    rigs.push_back(std::move(rig));
  }
  return rigs;
}

}  // namespace reeve::catalog
