// Options that take one of a few names, or a number of a range.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::cli {

// Like CLI::IsMember, and suggests the name that a mistyped one most likely means.
CLI::Validator one_of(std::vector<std::string> names);

// CLI11's own ranges of numbers let NaN pass, and hexadecimal digits.
CLI::Validator number_from(double low, double high);

}  // namespace reeve::cli
