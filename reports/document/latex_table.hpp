// One table as one or more tabulars of LaTeX (sheet_latex.hpp).
#pragma once

#include <string>

#include "reports/document/document.hpp"

namespace reeve::reports {

std::string latex(const Table& table, double width_pt);

// Below this the table stands out, or, if its columns were chosen, goes on in a further tabular.
double least_width_pt(const Table& table);

// Of a table whose columns were chosen. Throws InputError that says how much they take, and which
// of them fit.
void require_chosen_fit(const Table& table, double width_pt);

}  // namespace reeve::reports
