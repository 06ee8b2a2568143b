// Whether what is drawn has anything to do with the hardware as it is: ranges that nobody has given
// are those of Teflon on steel, whatever the hardware's own coefficients are.
#pragma once

#include <string>
#include <vector>

#include "core/hardware.hpp"
#include "core/uncertainty_ranges.hpp"

namespace reeve::reports {

// A sentence for each coefficient that its own range leaves out.
std::vector<std::string> range_notes(const Hardware& nominal, const UncertaintyRanges& ranges);

}  // namespace reeve::reports
