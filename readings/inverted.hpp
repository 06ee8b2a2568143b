// Channels whose sign is exchanged: a load cell that is mounted or wired the other way round reads
// the more below zero, the more is pulled. A zero that has drifted, or a slack strand, does not
// follow the load.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "readings/measured_data.hpp"

namespace reeve::readings {

// One note that names those channels. Nothing is changed: what else is exchanged with the sign, the
// file does not say.
std::optional<DataNote> note_inverted(const MeasuredData& data);
// The same of channels that are known; nothing of none.
std::optional<DataNote> note_on_inverted(const std::vector<std::string>& channels);

}  // namespace reeve::readings
