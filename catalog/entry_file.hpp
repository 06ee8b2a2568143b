// Reads one file of the catalogue; what may stand in it is described in catalogue.hpp.
#pragma once

#include "catalog/catalogue.hpp"
#include "catalog/toml_node.hpp"

namespace reeve::catalog {

// Throws InputError with file, line and column. Conflicts with other files are not checked: names
// that are taken, faults that refer to other routings.
CatalogueEntry read_entry(const TomlNode& file);

// Reads a name that the catalogue allows; throws InputError for anything else.
std::string read_name(const TomlNode& node);
// A routing that hangs on the motor, however it is spelt.
Routing read_actuated_word(const TomlNode& node);
// "like": the routing for other numbers of fingers, each once; none without the node.
std::vector<Routing> read_like(const TomlNode* node, const Routing& own);
// "held": fingers of a routing with so many.
Grasp read_held(const TomlNode& node, int fingers);
std::vector<Misprint> read_misprints(const TomlNode* node);

// "0.10": digits, with at most one point between them.
std::optional<PrintedNumber> parse_printed_number(const std::string& digits);
// The same of a text in quotes; throws InputError for anything else.
PrintedNumber read_printed_number(const TomlNode& node);

}  // namespace reeve::catalog
