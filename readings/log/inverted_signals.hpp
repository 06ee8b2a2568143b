// Channels of a log whose sign is exchanged, as in a file of readings (data/checks/inverted.hpp).
// It is asked of the samples, since of a motor tension that reads below zero no reading is made.
//
// What pulls is the size of the motor tension, or for that itself, and where there is none, the sum
// of the sizes of the other tensions. A channel is the other way round if it reads below zero in at
// least four of five samples of the half that pulls most, and its correlation with what pulls,
// within stretches of one label, is below -0.5.
#pragma once

#include <optional>

#include "readings/log/logged_series.hpp"
#include "readings/note.hpp"

namespace reeve::readings {

std::optional<DataNote> inverted_signals(const LoggedSeries& series);

}  // namespace reeve::readings
