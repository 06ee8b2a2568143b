// The tables of a hardware file, which a model file has, too: reading and writing.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/hardware_file.hpp"
#include "catalog/toml_node.hpp"

namespace reeve::catalog {

std::vector<std::string_view> hardware_table_names();

// Passes over tables of other names.
HardwareFile read_hardware_tables(const TomlNode& file);

// Returns the places of all keys, for errors that are found later.
std::shared_ptr<const HardwareOrigin> origin_of(const TomlNode& file);

// Returns TOML that read_hardware_tables reads back bit by bit.
std::string hardware_toml(const Hardware& hardware, const UncertaintyRanges& uncertainty,
                          const VaryTable& vary = {});

// Core knows the physical ranges; here its message gets the place in the file. Called after each
// table, so that the place is that of the table at fault.
void validate_at(const TomlNode& table, const Hardware& hardware);

}  // namespace reeve::catalog
