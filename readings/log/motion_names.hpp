// Names of columns that are not read as the position or the speed of the carriage, and may be one.
#pragma once

#include <string_view>

#include "numerics/floors.hpp"

namespace reeve::readings {

// It has the word: "position_rev", "Carriage speed".
bool says_motion(std::string_view name);
// "x_mm", "Weg [mm]".
bool has_unit_of_motion(std::string_view name);

}  // namespace reeve::readings
