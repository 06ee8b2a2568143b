// The hardware of a row that says its own wrap angle at the sheaths.
#pragma once

#include "core/hardware.hpp"

namespace reeve::diagnosis {

// With this wrap angle at every sheath, over what the hardware says of a finger or a contact.
Hardware with_sheath_angle(Hardware hardware, double angle_rad);

}  // namespace reeve::diagnosis
