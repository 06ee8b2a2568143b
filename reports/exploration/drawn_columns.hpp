// What drawn coefficients say of listed designs, column by column: named as in the CSV, to be
// chosen for a table.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reports/document/document.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

struct DrawnColumn {
  TableColumn column;                                    // its key is the name
  std::function<std::string(const ListedDesign&)> cell;  // "-" where nothing was drawn
};

// Place, constraints, and a median and two quantiles of each objective that friction moves.
std::vector<DrawnColumn> drawn_columns(bool with_hand, bool with_constraints);

}  // namespace reeve::reports
