#include "catalog/rig/hardware_file.hpp"

#include "catalog/rig/hardware_tables.hpp"
#include "catalog/toml_node.hpp"

namespace reeve::catalog {

HardwareFile read_hardware_file(const std::filesystem::path& path) {
  const TomlNode file = read_toml(path);
  file.allow_only(hardware_table_names());
  return read_hardware_tables(file);
}

Hardware read_hardware(const std::filesystem::path& path) {
  return read_hardware_file(path).hardware;
}

}  // namespace reeve::catalog
