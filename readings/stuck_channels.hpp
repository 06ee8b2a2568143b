// Sensors that read the same in a whole run, whatever pulls: an amplifier that hangs, a plug that
// is out. Their readings say nothing of the rig.
//
// A channel is stuck in a run if its readings there, 5 at least and not 0 alone, span less than 2 %
// of the most that they span in another run of the routing, while the motor tension spans over half
// of the most that it does there. Other runs have ten different readings, so that a coarse step is
// no sign of it.
#pragma once

#include "readings/measured_data.hpp"

namespace reeve::readings {

// Takes these readings out, and notes it.
void leave_out_stuck_channels(MeasuredData& data);

}  // namespace reeve::readings
