// Channels whose sign is exchanged: a load cell that is mounted or wired the other way round reads
// the more below zero, the more is pulled. A zero that has drifted, or a slack strand, does not
// follow the load.
#pragma once

#include <vector>

#include "diagnosis/data/measured_data.hpp"

namespace reeve::diagnosis {

// One note that names those channels. Nothing is changed: what else is exchanged with the sign, the
// file does not say. Empty if there are none.
std::vector<DataNote> notes_inverted(const MeasuredData& data);

}  // namespace reeve::diagnosis
