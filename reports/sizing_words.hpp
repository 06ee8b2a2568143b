// Words of a sizing, for tables and files.
#pragma once

#include <string>

#include "studies/sizing_study.hpp"

namespace reeve::reports {

// "the 5 % quantile of uniformity_mean x efficiency_mean over 100 draws of the coefficients"
std::string goal_text(const SizingOptions& options);
// "TR1 (M-1-T-2-F)", or the word alone.
std::string title_of(const SizedRouting& routing);
// "0.0347 -> 0.164 (+371.0 %)"; of a target without the percentage.
std::string gain_text(const SizingOptions& options, const SizedDesign& design);

// "so far off alone before 1 % of the goal is lost", of a target "before shares miss by 0.01 more".
std::string tolerance_text(const SizingOptions& options);
// Explains "any" beside a number; "" if no number has it.
std::string any_text(const SizedDesign& design);
// Says how far all dimensions may be off at once, in a sentence; the design has tolerances.
std::string together_text(const SizingOptions& options, const SizedDesign& design);
// "sheath_angle[1] by +0.3 rad with tip_angle[1,2] by -0.1 rad"
std::string moves_text(const SizedDesign& design, const std::vector<double>& moves,
                       const char* between = " with ");

}  // namespace reeve::reports
