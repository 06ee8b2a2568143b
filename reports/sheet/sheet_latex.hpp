// A sheet as LaTeX: each table a whole tabular with the rules of booktabs, to be read in with
// \input. Caveats are typeset; titles and other lines are comments.
#pragma once

#include <string>

#include "reports/sheet/sheet.hpp"

namespace reeve::reports {

std::string latex(const Sheet& sheet);

// Text as LaTeX typesets it, with any engine.
std::string latex_escaped(const std::string& text);

}  // namespace reeve::reports
