// Reads one file of a family; what may stand in it is described in mechanism.hpp.
#pragma once

#include <string>

#include "catalog/mechanisms/mechanism.hpp"
#include "catalog/toml_node.hpp"

namespace reeve::catalog {

// Throws InputError with file, line and column. Does not check if the name is taken.
Mechanism read_mechanism(const TomlNode& file, const std::string& family);

}  // namespace reeve::catalog
