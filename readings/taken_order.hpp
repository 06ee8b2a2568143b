// In what order readings were taken: by the clock where every row has one, else as the file has
// them. A clock may begin again with each run; runs then follow one another as in the file.
#pragma once

#include <cstddef>
#include <optional>

#include "readings/measured_data.hpp"

namespace reeve::readings {

// The covariate that is a clock, which every row has.
std::optional<std::size_t> clock_of(const MeasuredData& data);

// Reading::taken of each.
void set_taken(MeasuredData& data);

}  // namespace reeve::readings
