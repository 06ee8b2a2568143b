// Options that take one of a few names.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::cli {

// Like CLI::IsMember, and suggests the name that a mistyped one most likely means.
CLI::Validator one_of(std::vector<std::string> names);

}  // namespace reeve::cli
