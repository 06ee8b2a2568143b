// What looks wrong in data that can be read: repeated rows, tensions in another unit, a motor-side
// segment with more than the motor gives, rows that were commented out, unknown columns.
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

// Readings that are copies of an earlier one (checks/copies.hpp), ascending.
std::vector<std::size_t> repeated_readings(const MeasuredData& data);

std::vector<DataNote> data_notes(const MeasuredData& data,
                                 const std::vector<CsvComment>& comments_below_the_header);

}  // namespace reeve::readings
