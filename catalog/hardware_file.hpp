// Reads a hardware file (TOML): friction and lengths of the user's parts, and how well they are
// known. catalog/hardware/example.toml shows every key. What is not given has its default, so that
// an empty file is the paper's hardware.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/hardware.hpp"
#include "core/uncertainty_ranges.hpp"

namespace reeve::catalog {

// Bounds from the table [vary]. The module sizing checks that the dimension exists.
struct GivenBounds {
  std::string name;  // "sheath_angle[1]"
  double low = 0;
  double high = 0;
  std::string place;  // "h.toml:3:1: vary"
};
struct GivenEqual {
  std::string text;  // "tips"
  std::string place;
};
struct VaryTable {
  std::vector<GivenBounds> bounds;
  std::vector<GivenEqual> equal;
};

struct HardwareFile {
  Hardware hardware;
  UncertaintyRanges uncertainty;
  VaryTable vary{};
};

// Both throw InputError with file, line, column, key, value and what was expected.
HardwareFile read_hardware_file(const std::filesystem::path& path);
// Parses the text of a file; `name` stands for the file in messages.
HardwareFile parse_hardware_file(const std::string& text, const std::string& name);

}  // namespace reeve::catalog
