// Channels whose sign is exchanged: a load cell that is mounted or wired the other way round reads
// the more below zero, the more is pulled. A zero that has drifted, or a slack strand, does not
// follow the load.
//
// A channel is the other way round if it reads below zero in at least four of five rows, and the
// mean of its correlation with what pulls, over groups of rows that are alike but for the load, is
// below -0.5. What pulls is the motor tension, and where there is none, the sum of the sizes of the
// other tensions.
#pragma once

#include <optional>

#include "readings/log/logged_series.hpp"
#include "readings/measured_data.hpp"

namespace reeve::readings {

// Both return one note that names those channels; nothing if there are none. Nothing is changed:
// what else is exchanged with the sign, the file does not say.
std::optional<DataNote> inverted_channels(const MeasuredData& data);

// It is asked of the samples, since of a motor tension that reads below zero no reading is made.
// Four of five are below zero in the half that pulls most, and what pulls is the size of the motor
// tension, or for that itself the sum of the others. Samples of one label are alike.
std::optional<DataNote> inverted_signals(const LoggedSeries& series);

}  // namespace reeve::readings
