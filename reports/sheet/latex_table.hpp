// One table as one or more tabulars of LaTeX (sheet_latex.hpp).
#pragma once

#include <string>

#include "reports/sheet/sheet.hpp"

namespace reeve::reports {

std::string latex(const Table& table, double width_pt);

}  // namespace reeve::reports
