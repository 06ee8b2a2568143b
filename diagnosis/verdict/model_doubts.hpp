// Doubts readings by the hardware as it is given, before anything is fitted. T are the readings, m
// their forecasts.
//
// Channels that read in another unit than the motor's:
//
//   x = median over a channel's readings of ln (T / m)
//
// is within a tenth of -ln 9.81 (kgf, or daN), -ln 4.45 (lbf) or -ln 1000 (kN), or of one of these
// above zero where newtons were taken for such a unit. The median distance from it is less than a
// tenth, too, and no other channel's x is beyond half of it: no friction is so even, and no
// sensor's gain so large.
//
// Rows that read as if the carriage had gone the other way than the file says: with d = median over
// the strands |ln (T / m)|, m for the direction recorded, and d' that for the other direction, a
// row is odd if
//
//   d > 3 max(d', t)   and   d > 0.1,
//
// t: the median over all rows of the lesser of both, which is what coefficients and noise leave.
// Friction takes from the tension on the way from a pulling motor and adds to it on the way to a
// releasing one, so that which is the nearer hardly hangs on the coefficients; and the other
// direction has to fit about as well as rows do. More than a fifth of the rows of a run, and three,
// are noted: one run with a wrong direction is a small part of a file, and search would explain it
// by whatever comes near.
//
// Rows whose motor tension was written a row late or early: with x = median over the strands
// ln (T / m), and M the motor tension, the median distance of x_i from the median of its block is
// over 5 %, and three times that of x_i + ln (M_i / M_j), j the neighbour in its run.
//
// Rows without motor tension say nothing here.
#pragma once

#include <optional>
#include <vector>

#include "causes/model.hpp"
#include "diagnosis/dataset.hpp"
#include "readings/note.hpp"

namespace reeve::diagnosis {

// A note for each unit. There have to be two other channels, or none.
std::vector<DataNote> notes_on_channel_units(const Dataset& all, const Model& nominal);

// Returns nothing if no run has so many odd rows.
std::optional<DataNote> note_on_other_direction(const MeasuredData& data,
                                                const std::vector<std::size_t>& readings,
                                                const Model& nominal);

std::optional<DataNote> note_on_shifted_rows(const MeasuredData& data,
                                             const std::vector<std::size_t>& readings,
                                             const Model& nominal);

}  // namespace reeve::diagnosis
