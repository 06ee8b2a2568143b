#include "catalog/hardware_file.hpp"

#include "catalog/hardware_tables.hpp"
#include "catalog/toml_node.hpp"

namespace reeve::catalog {

namespace {

HardwareFile hardware_of(const TomlNode& file) {
  file.allow_only(hardware_table_names());
  return read_hardware_tables(file);
}

}  // namespace

HardwareFile read_hardware_file(const std::filesystem::path& path) {
  const TomlNode file = read_toml(path);
  HardwareFile result = hardware_of(file);
  result.hardware.origin = origin_of(file);
  return result;
}

HardwareFile parse_hardware_file(const std::string& text, const std::string& name) {
  return hardware_of(parse_toml(text, name));
}

}  // namespace reeve::catalog
