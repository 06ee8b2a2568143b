// Runs in which no sensor says anything, as where an amplifier was off: no tension in any row, or 0
// in all of them at loads at which the other runs read something.
#pragma once

#include "readings/measured_data.hpp"

namespace reeve::readings {

// True if some sensor has a reading.
bool has_tension(const Reading& reading);

// Takes them out, and notes it. Where all runs are silent, none is taken out.
void leave_out_silent_runs(MeasuredData& data);

}  // namespace reeve::readings
