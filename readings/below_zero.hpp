// Readings below zero. A tendon cannot push, but the zero of a load cell drifts, so a tension below
// zero is a reading of a slack strand or of a shifted zero: it is used and counted. A motor tension
// below zero scales nothing, since the model's tensions are multiples of it: such a row is left
// out.
#pragma once

#include <vector>

#include "readings/measured_data.hpp"

namespace reeve::readings {

// Takes out the rows with a motor tension below zero; the note names their lines. Empty if there
// are none.
std::vector<DataNote> leave_out_negative_motor_tensions(MeasuredData& data);

// One note that counts the tensions below zero of each channel; empty if there are none.
std::vector<DataNote> notes_below_zero(const MeasuredData& data);

}  // namespace reeve::readings
