// A sheet as LaTeX: each table a whole tabular with the rules of booktabs, to be read in with
// \input. Caveats are typeset; titles and other lines are comments. It needs no other package:
// numbers of a column stand with their decimal marks below each other since the shorter ones are
// filled up with phantoms.
//
// With a width, tables are in \footnotesize and no wider: headings go over several lines, and texts
// are wrapped, routings at their dashes. What is still too wide is, of a table whose columns were
// chosen, an error that says which of them fit; otherwise columns are left out, as in a narrow
// window, or stand in a further table below, with the first column again.
#pragma once

#include <string>

#include "reports/sheet/sheet.hpp"

namespace reeve::reports {

// Throws InputError of chosen columns that are too wide.
std::string latex(const Sheet& sheet, double width_pt = 0);  // 0: any

// What the widest of the tables takes if everything is done to make it narrow: below, it stands
// out.
double least_width_pt(const Sheet& sheet);

// Text as LaTeX typesets it, with any engine.
std::string latex_escaped(const std::string& text);

}  // namespace reeve::reports
