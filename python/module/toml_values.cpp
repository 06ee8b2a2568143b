#include "python/module/toml_values.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "python/module/arguments.hpp"

namespace reeve::python {
namespace {

using catalog::TomlKind;
using catalog::TomlNode;

bool is_mapping(const py::handle& value) {
  return PyMapping_Check(value.ptr()) != 0 && py::hasattr(value, "items");
}

bool is_list(const py::handle& value) {
  return py::isinstance<py::iterable>(value) && !py::isinstance<py::str>(value);
}

TomlNode node_from(const py::handle& value, const std::string& argument, TomlNode node);

void add_table(const py::handle& value, const std::string& argument, TomlNode& node) {
  node.kind = TomlKind::table;
  for (const py::handle& item : value.attr("items")()) {
    const auto [key, inner] = item.cast<std::pair<py::object, py::object>>();
    TomlNode child;
    child.key = py::str(key);  // a finger's number is a key, too
    child.name = node.name + "." + child.key;
    node.children.push_back(
        node_from(inner, fmt::format("{}[{}]", argument, std::string(py::repr(key))), child));
  }
}

void add_array(const py::handle& value, const std::string& argument, TomlNode& node) {
  node.kind = TomlKind::array;
  for (const py::handle& item : value) {
    const std::string place = fmt::format("[{}]", node.children.size());
    TomlNode child;
    child.name = node.name + place;
    node.children.push_back(node_from(item, argument + place, child));
  }
}

TomlNode node_from(const py::handle& value, const std::string& argument, TomlNode node) {
  static const auto file = std::make_shared<const std::string>("Hardware");
  node.file = file;
  if (is_mapping(value)) {
    add_table(value, argument, node);
  } else if (is_list(value)) {
    add_array(value, argument, node);
  } else if (py::isinstance<py::str>(value)) {
    node.kind = TomlKind::string;
    node.content = value.cast<std::string>();
  } else {
    node.number = number_from(value, argument);
    node.kind = py::isinstance<py::bool_>(value)  ? TomlKind::boolean
                : PyIndex_Check(value.ptr()) != 0 ? TomlKind::integer
                                                  : TomlKind::floating;
  }
  return node;
}

py::object table_of(const TomlNode& node) {
  py::dict table;
  for (const TomlNode& child : node.children) table[py::str(child.key)] = value_of(child);
  return table;
}

py::object list_of(const TomlNode& node) {
  py::list list;
  for (const TomlNode& child : node.children) list.append(value_of(child));
  return list;
}

}  // namespace

TomlNode toml_from(const py::handle& value, const std::string& name, const std::string& key) {
  if (!is_mapping(value)) throw wrong_type(name, "a mapping", value);
  TomlNode node;
  node.key = key;
  node.name = key;
  return node_from(value, name, node);
}

py::object value_of(const TomlNode& node) {
  switch (node.kind) {
    case TomlKind::table:
      return table_of(node);
    case TomlKind::array:
      return list_of(node);
    case TomlKind::boolean:
      return py::bool_(node.number != 0);
    case TomlKind::integer:
    case TomlKind::floating:
      return py::float_(node.number);
    case TomlKind::string:
    case TomlKind::date:
      break;
  }
  return py::str(node.content);
}

}  // namespace reeve::python
