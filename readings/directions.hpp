// Rows whose direction the file does not say are taken as pulled. Whether that can be is seen from
// the tensions alone, whatever the coefficients: while the carriage pulls, friction takes from the
// tension on the way from the motor, so that without floating blocks
//
//   T_strand ≤ T_M
//
// and while it releases, friction adds to it, so that over the strands beside the sheaths Σ T ≥
// T_M. Where more than a fifth of the pulled rows break the first by more than 5 %, each of these
// is tried: the other direction, the motor tension exchanged with another column, and the motor
// tension in another unit. What leaves at most 5 % of the rows broken would mend it.
//
// Assumption: no strand slides back while the carriage pulls, as between two fingers of which one
// is held it may; hence the fifth.
#pragma once

#include "readings/measured_data.hpp"

namespace reeve::readings {

inline constexpr double direction_tolerance = 0.05;  // share of the motor tension
inline constexpr double most_broken_rows = 0.2;      // before it is noted
inline constexpr double most_broken_if_mended = 0.05;

// Notes how many rows have no direction, and whether pulling fits.
void note_directions(MeasuredData& data);

}  // namespace reeve::readings
