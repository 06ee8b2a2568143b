// Middle and spread of numbers of which some are wild. NaN is passed over.
#pragma once

#include <vector>

#include "numerics/floors.hpp"

namespace reeve::numerics {

// The mean of the two in the middle of an even number; NaN of none.
double median(std::vector<double> values);

// The value below which this share of them lies; NaN of none.
double quantile_of(std::vector<double> values, double share);

// Standard deviation of normal numbers about 0: median |v| / 0.6745. Returns 0 for none.
double mad_about_zero(std::vector<double> values);

// Standard deviation of independent normal noise upon series that bend slowly. It uses second
// differences, which for noise deviate √6 times as far. Returns 0 for none.
double deviation_about_trend(const std::vector<std::vector<double>>& series);

}  // namespace reeve::numerics
