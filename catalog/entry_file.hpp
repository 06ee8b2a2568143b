// Reads one file of the catalogue; what may stand in it is described in catalogue.hpp.
#pragma once

#include "catalog/catalogue.hpp"
#include "catalog/toml_node.hpp"

namespace reeve::catalog {

// Throws InputError with file, line and column. What concerns other files (names that are taken,
// faults that refer to other routings) is not looked at.
CatalogueEntry read_entry(const TomlNode& file);

// "0.10": digits, with at most one point between them.
std::optional<PrintedNumber> parse_printed_number(const std::string& digits);
// The same of a text in quotes; throws InputError for anything else.
PrintedNumber read_printed_number(const TomlNode& node);

}  // namespace reeve::catalog
