// The cells of a row that are words. All throw InputError that says what was expected; the place is
// the caller's to name.
#pragma once

#include <optional>
#include <string_view>

#include "core/grasp.hpp"

namespace reeve::readings {

// "1;2", "1,2", "none"; of a routing of so many fingers.
Grasp read_held(std::string_view text, int fingers);
// Nothing of an empty cell.
std::optional<Direction> read_direction(std::string_view text);
// A row that has zeros in place of readings.
bool says_tare(std::string_view text);

}  // namespace reeve::readings
