// Readings far from all others of their kind: a slipped decimal point, a spike of the logger. They
// are set aside, cell by cell, before anything is concluded from the data.
//
// What a cell should read is its level among the others (polished_levels.hpp).
//
// A cell is far if it is off by more than a factor of five, by more than 20 median absolute
// deviations in logarithms, by more than 20 in newton, and by more than ten steps of its sensor.
//
// One whose value is that of the row above, and comes nowhere else, is far if it is off by more
// than a tenth, 6 deviations and ten steps: the logger has held it. However many there are, they
// are set aside.
//
// A cause in the rig is no slip. So nothing is set aside of a row or of a run's channel if more
// than half of its cells are far (of one cell: none of the rest of its row), and nothing at all if
// more than 2 % of all cells are. Kinds of fewer than five rows have no "others".
#pragma once

#include "readings/measured_data.hpp"

namespace reeve::readings {

inline constexpr double outlier_factor = 5;
inline constexpr double outlier_deviations = 20;
inline constexpr double held_factor = 1.1;
inline constexpr double held_deviations = 6;
inline constexpr double outlier_steps = 10;
inline constexpr double most_outliers = 0.02;  // share of all cells; one cell is always allowed

// Makes far cells missing, and takes out rows that have no tension left. A note names lines,
// channels, values and what the others read.
void set_outliers_aside(MeasuredData& data);

}  // namespace reeve::readings
