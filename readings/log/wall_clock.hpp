// Text of a clock on the wall, which is no number of seconds.
#pragma once

#include <string_view>

#include "numerics/floors.hpp"

namespace reeve::readings {

// "12:00:00.01", "2024-05-01T12:00:00Z"
bool is_time_of_day(std::string_view text);
// One of these, a date alone ("2024-05-01", "1.5.2024", "5/1/24"), or whatever else a colon parts
// numbers in.
bool is_date_or_time(std::string_view text);

}  // namespace reeve::readings
