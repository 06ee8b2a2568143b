// Channels that read in another unit than the motor's, by what the hardware as it is given says.
//
//   x = median over a channel's readings of ln (T / m)
//
// is within a tenth of -ln 9.81 (kgf, or daN), -ln 4.45 (lbf) or -ln 1000 (kN), or of one of these
// above zero where newtons were taken for such a unit. The median distance from it is less than a
// tenth, too, and no other channel's x is beyond half of it: no friction is so even, and no
// sensor's gain so large.
#pragma once

#include <vector>

#include "causes/model.hpp"
#include "diagnosis/dataset.hpp"
#include "readings/note.hpp"

namespace reeve::diagnosis {

// A note for each unit. There have to be two other channels, or none.
std::vector<DataNote> notes_on_channel_units(const Dataset& all, const Model& nominal);

}  // namespace reeve::diagnosis
