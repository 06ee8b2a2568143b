// One table as one or more tabulars of LaTeX (sheet_latex.hpp).
#pragma once

#include <string>

#include "reports/sheet/sheet.hpp"

namespace reeve::reports {

std::string latex(const Table& table, double width_pt);

// Below this a table of columns that nobody chose is wider than it was asked to be.
double least_width_pt(const Table& table);

}  // namespace reeve::reports
