// How wide text is when LaTeX typesets it, near enough to say whether a table fits: by the widths
// of Computer Modern in \footnotesize of a document in 10 pt, which are those of most papers in two
// columns. Times, which many of them use, is narrower.
#pragma once

#include <string>

#include "numerics/floors.hpp"

namespace reeve::reports {

// Returns the width of a text before it is escaped, in pt of 1/72.27 in.
double latex_width_pt(const std::string& text);

inline constexpr double pt_in_mm = 72.27 / 25.4;

}  // namespace reeve::reports
