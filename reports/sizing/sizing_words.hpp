// What a sizing says of itself, for tables and files.
#pragma once

#include <string>

#include "studies/sizing/sizing_study.hpp"

namespace reeve::reports {

// "the 5 % quantile of uniformity_mean x efficiency_mean over 100 draws of the coefficients"
std::string goal_text(const SizingOptions& options);
// "TR1 (M-1-T-2-F)", or the word alone.
std::string title_of(const SizedRouting& routing);
// "0.0347 -> 0.164 (+371.0 %)"; of a target without the percentage.
std::string gain_text(const SizingOptions& options, const SizedDesign& design);

}  // namespace reeve::reports
