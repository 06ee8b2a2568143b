// Held-out readings that are far from what the final model forecasts for them: something is
// different there that no training run knows, such as a grasp that was meant to be another.
//
//   |e| > t,   e = (T − m) / sd, of noise and mountings together
//
// t: Student's that chance exceeds anywhere among the held-out readings in a quarter of alpha of
// data sets, of 6 degrees of freedom at most: a few hundred readings cannot tell that their noise
// has no heavier tails.
#pragma once

#include <optional>
#include <vector>

#include "diagnosis/fit/noise.hpp"
#include "diagnosis/verdict/compared_cell.hpp"
#include "readings/measured_data.hpp"

namespace reeve::diagnosis {

// Nothing if there is none.
std::optional<DataNote> outlier_forecasts(const std::vector<ComparedCell>& cells,
                                          const MeasuredData& data, const Noise& noise,
                                          double alpha);

}  // namespace reeve::diagnosis
