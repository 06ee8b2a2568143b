// Middle and spread of numbers of which some are wild. NaN is passed over.
#pragma once

#include <vector>

#include "numerics/floors.hpp"

namespace reeve::numerics {

// The mean of the two in the middle of an even number; NaN of none.
double median(std::vector<double> values);

// The value below which this share of them lies; NaN of none.
double quantile_of(std::vector<double> values, double share);

// Of normal numbers about 0, their standard deviation: median |v| / 0.6745. 0 of none.
double mad_about_zero(std::vector<double> values);

// Of independent normal noise upon series that bend slowly, its standard deviation, by their second
// differences: those of noise deviate √6 times as far. 0 of none.
double deviation_about_trend(const std::vector<std::vector<double>>& series);

}  // namespace reeve::numerics
