// Reads the rigs of a mechanism: hardware of its own, in which an expression may stand wherever a
// hardware file has a number (mechanism.hpp).
#pragma once

#include <string_view>
#include <vector>

#include "catalog/mechanisms/mechanism.hpp"
#include "catalog/toml_node.hpp"

namespace reeve::catalog {

// [hardware] and [rig.NAME] of the mechanism's file. The first rig is that of its own hardware,
// with no name; of the others, what is not given is as there. Throws InputError.
std::vector<Rig> read_rigs(const TomlNode& file);

Expression read_expression(const TomlNode& node);

}  // namespace reeve::catalog
