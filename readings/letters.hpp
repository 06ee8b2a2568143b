// Letters of motor-side segments that may be meant otherwise: reeve's run in walk order, and the
// Exo-Glove II paper has a, b, c, d beside T1, T2, T3, T4 whatever the walk.
#pragma once

#include <vector>

#include "readings/measured_data.hpp"

namespace reeve::readings {

// One note for each routing with a measured letter for which the two differ. `lettered`: whether a
// column has a letter at all, in place of the strand that it is beside.
std::vector<DataNote> notes_on_letters(const MeasuredData& data, bool lettered);

}  // namespace reeve::readings
