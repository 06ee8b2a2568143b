// Tables of a hardware file as mappings, lists and numbers, by the names that they have there.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "catalog/toml_node.hpp"

namespace reeve::python {

// A mapping is a table, a sequence an array. `name` is that of the argument ("fingers") in a
// TypeError, the key that of the file ("finger"). Its place in a file is not known.
catalog::TomlNode toml_from(const pybind11::handle& value, const std::string& name,
                            const std::string& key);

pybind11::object value_of(const catalog::TomlNode& node);

}  // namespace reeve::python
