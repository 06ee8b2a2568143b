// Sensors that read the same in a whole run, whatever pulls: an amplifier that hangs, a plug that
// is out. Their readings say nothing of the rig.
//
// A channel is stuck in a run if its readings there, 5 at least, span less than a tenth of their
// median and less than 2 % of the most that they span in a run of the routing, while the motor
// tension spans over half of the most that it does. The least and the greatest reading of a run,
// one of which may be a bad cell, do not count. Other runs have ten different readings, so that a
// coarse step is no sign of it.
#pragma once

#include "readings/measured_data.hpp"

namespace reeve::readings {

// Takes these readings out, and notes it.
void leave_out_stuck_channels(MeasuredData& data);

}  // namespace reeve::readings
