// A channel that reads in another unit than the others, by what the hardware as it is given says.
//
//   x = median over its readings of ln (T / m)
//
// is within a tenth of -ln 9.81 (kgf), -ln 4.45 (lbf), -ln 10 (daN) or -ln 1000 (kN), or of one of
// these above zero where newtons were taken for such a unit. The middle distance from it is less
// than a tenth, too, and no other channel's x is beyond half of it: no friction is so even, and no
// sensor's gain so large.
#pragma once

#include <vector>

#include "causes/model.hpp"
#include "diagnosis/dataset.hpp"
#include "readings/note.hpp"

namespace reeve::diagnosis {

// A note for each such channel. There have to be two others.
std::vector<DataNote> notes_on_channel_units(const Dataset& all, const Model& nominal);

}  // namespace reeve::diagnosis
