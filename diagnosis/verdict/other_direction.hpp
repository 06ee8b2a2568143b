// Rows that read as if the carriage had gone the other way than the file says.
//
// With d = median over the strands |ln (T / m)|, m the forecast of the hardware as it is given for
// the direction recorded, and d' that for the other direction, a row is odd if
//
//   d > 3 max(d', t)   and   d > 0.1,
//
// t: the median over all rows of the lesser of both, which is what coefficients and noise leave.
// Friction takes from the tension on the way from a pulling motor and adds to it on the way to a
// releasing one, so that which is the nearer hardly hangs on the coefficients; and the other
// direction has to fit about as well as rows do. More than a fifth of the rows of a run, and three,
// are noted: one run with a wrong direction is a small part of a file, and search would explain it
// by whatever comes near.
#pragma once

#include <optional>
#include <vector>

#include "causes/model.hpp"
#include "diagnosis/dataset.hpp"
#include "readings/note.hpp"

namespace reeve::diagnosis {

inline constexpr double odd_direction_factor = 3;
inline constexpr double least_odd_direction = 0.1;
inline constexpr double most_odd_of_a_run = 0.2;
inline constexpr std::size_t least_odd_rows = 3;

// Nothing if no run has so many. Rows without motor tension say nothing here.
std::optional<DataNote> note_on_other_direction(const MeasuredData& data,
                                                const std::vector<std::size_t>& readings,
                                                const Model& nominal);

}  // namespace reeve::diagnosis
