// What looks wrong in data that can be read: repeated rows, tensions in another unit, a motor-side
// segment with more than the motor gives, rows that were commented out, unknown columns.
#pragma once

#include <vector>

#include "readings/csv.hpp"
#include "readings/measured_data.hpp"

namespace reeve::readings {

// Readings below zero. A tendon cannot push, but the zero of a load cell drifts, so a tension below
// zero is a reading of a slack strand or of a shifted zero: it is used and counted. A motor tension
// below zero scales nothing, since the model's tensions are multiples of it: such a row is left
// out.

// Takes out the rows with a motor tension below zero; the note names their lines. Empty if there
// are none.
std::vector<DataNote> leave_out_negative_motor_tensions(MeasuredData& data);

// One note that counts the tensions below zero of each channel; empty if there are none.
std::vector<DataNote> notes_below_zero(const MeasuredData& data);

// Letters of motor-side segments that may be meant otherwise: reeve's run in walk order, and the
// Exo-Glove II paper has a, b, c, d beside T1, T2, T3, T4 whatever the walk.

// One note for each routing with a measured letter for which the two differ. `lettered`: whether a
// column has a letter at all, in place of the strand that it is beside.
std::vector<DataNote> notes_on_letters(const MeasuredData& data, bool lettered);

// A motor-side segment may read this much more than the motor tension before it is noted: sensors
// are calibrated to some per cent.
inline constexpr double motor_side_tolerance = 0.05;

// Beyond these, tensions are likely in another unit. No strand of a known routing gets less than
// 1/100 of the motor tension or, releasing, more than twenty times of it; and tendons of hands
// carry some newtons.
inline constexpr double least_plausible_ratio = 0.002;
inline constexpr double greatest_plausible_ratio = 20;
inline constexpr double least_plausible_tension_N = 1e-2;
inline constexpr double greatest_plausible_tension_N = 1e4;

// Readings that are copies of an earlier one (checks/copies.hpp), ascending.
std::vector<std::size_t> repeated_readings(const MeasuredData& data);

std::vector<DataNote> data_notes(const MeasuredData& data,
                                 const std::vector<CsvComment>& comments_below_the_header);

}  // namespace reeve::readings
