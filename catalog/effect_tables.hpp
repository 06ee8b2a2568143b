// The [[effect]] tables of a model file. Nothing here knows a cause by name: what a table must hold
// follows from the cause's parameters and from the kind of its subject.
#pragma once

#include <string>

#include "catalog/catalogue.hpp"
#include "catalog/toml_node.hpp"
#include "causes/model.hpp"

namespace reeve::catalog {

// Adds the effect to the model, whose hardware must be read already. A routing is a word or a name
// of the catalogue.
void read_effect(const TomlNode& table, const Catalogue& catalogue, Model& model);

std::string effect_toml(const Effect& effect, const Hardware& hardware);

}  // namespace reeve::catalog
