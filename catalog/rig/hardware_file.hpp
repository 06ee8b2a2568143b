// Reads a hardware file (TOML): friction and lengths of the user's parts, and how well they are
// known. catalog/hardware/example.toml shows every key. What is not given has its default, so that
// an empty file is the paper's hardware.
#pragma once

#include <filesystem>

#include "core/hardware.hpp"
#include "core/uncertainty_ranges.hpp"

namespace reeve::catalog {

struct HardwareFile {
  Hardware hardware;
  UncertaintyRanges uncertainty;
};

// Both throw InputError with file, line, column, key, value and what was expected.
HardwareFile read_hardware_file(const std::filesystem::path& path);
Hardware read_hardware(const std::filesystem::path& path);

}  // namespace reeve::catalog
