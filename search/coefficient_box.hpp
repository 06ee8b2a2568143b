// The coefficients that are uncertain, as a box: mu of tubes, sheaths and bearings, angle of
// sheaths. A point of it holds for all parts of a kind at once (one spool of liner, one sort of
// bearing); what the hardware file sets for single fingers or contacts stays as it is. The ranges
// of mu are widened to hold the nominal values, if need be.
#pragma once

#include <array>
#include <vector>

#include "core/hardware.hpp"
#include "core/uncertainty_ranges.hpp"
#include "numerics/minimise.hpp"

namespace reeve {

using CoefficientBox = std::array<Interval, 4>;

CoefficientBox coefficient_box(const Hardware& nominal, const UncertaintyRanges& ranges);

// `point` has one value for each interval of the box.
Hardware at_point(const Hardware& nominal, const std::vector<double>& point);

}  // namespace reeve
