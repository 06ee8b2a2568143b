// A document as LaTeX: each table a whole tabular with the rules of booktabs, to be read in with
// \input. Caveats are typeset; titles and other lines are comments. It needs no other package:
// numbers of a column stand with their decimal marks below each other since the shorter ones are
// filled up with phantoms.
//
// With a width, tables are in \footnotesize and no wider: headings go over several lines, and texts
// are wrapped, routings at their dashes. If a table is still too wide, columns that nobody chose
// are left out, as in a narrow window, or columns stand in a further table below, with the first
// again. A table that is known beforehand to be too wide is refused before the work (require_fits).
#pragma once

#include <string>

#include "numerics/floors.hpp"
#include "reports/document/document.hpp"

namespace reeve::reports {

std::string latex(const Document& document, double width_pt = 0);  // 0: any

// Returns the width of the widest table if everything is done to make it narrow. Below this width,
// it stands out.
double least_width_pt(const Document& document);

// Checks a document with the shortest cells that it may come to have. Throws InputError that says
// how much width it takes.
void require_fits(const Document& document, double width_pt);

// Text as LaTeX typesets it, with any engine.
std::string latex_escaped(const std::string& text);

// Returns the width of a text before it is escaped, in pt of 1/72.27 in.
double latex_width_pt(const std::string& text);

inline constexpr double pt_in_mm = 72.27 / 25.4;

}  // namespace reeve::reports
