// Notes on doubtful data that can be read: repeated rows, tensions in another unit, a motor-side
// segment with more than the motor tension, rows that were commented out, unknown columns.
#pragma once

#include <vector>

#include "readings/csv.hpp"
#include "readings/measured_data.hpp"

namespace reeve::readings {

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

// Notes routings with letters of motor-side segments that may be meant otherwise: reeve's run in
// walk order, and the Exo-Glove II paper has a, b, c, d beside T1, T2, T3, T4 whatever the walk.
void note_letters(MeasuredData& data);

// Takes out the rows with a motor tension below zero. It scales nothing, since the model's tensions
// are multiples of it. Throws InputError if no row is left.
void leave_out_negative_motor_tensions(MeasuredData& data);

// Notes all else. Tensions below zero are counted and used: a tendon cannot push, but the zero of a
// load cell drifts, so that they are readings of a slack strand or of a shifted zero.
void note_what_looks_wrong(MeasuredData& data,
                           const std::vector<CsvComment>& comments_below_the_header);

}  // namespace reeve::readings
