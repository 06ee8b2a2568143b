// Readings far from all others of their kind: a slipped decimal point, a spike of the logger. They
// are set aside, cell by cell, before anything is concluded from the data.
//
// Model: among the rows of one routing, grasp and direction, ln T(row, channel) ≈ s(row) +
// l(channel), since tensions are nearly proportional to the load. s and l are medians taken in turn
// (Tukey's median polish), so one wild cell moves neither. The motor tension is one of the
// channels; where a row has less than three of them, it is the scale itself, and the row's median
// where there is none.
//
// A cell is far if it is off by more than a factor of five, by more than 20 median absolute
// deviations in logarithms, by more than 20 in newton, and by more than ten steps of its sensor.
//
// A cause in the rig is no slip. So nothing is set aside of a row or of a run's channel if more
// than half of its cells are far (of one cell: none of the rest of its row), and nothing at all if
// more than 2 % of all cells are. Kinds of fewer than five rows have no "others".
//
// Source: Tukey, Exploratory Data Analysis (1977), chapter 11.
#pragma once

#include <vector>

#include "diagnosis/data/measured_data.hpp"

namespace reeve::diagnosis {

inline constexpr double outlier_factor = 5;
inline constexpr double outlier_deviations = 20;
inline constexpr double outlier_steps = 10;
inline constexpr double most_outliers = 0.02;  // of all cells; one in any case

// Makes far cells missing, and takes out rows that have no tension left. The notes name lines,
// channels, values and what the others read; empty if nothing is far.
std::vector<DataNote> set_outliers_aside(MeasuredData& data);

}  // namespace reeve::diagnosis
