// Values of objectives as text: with the decimals of the objective. A cost has the unit of
// somebody's prices, of which two decimals may tell nothing (kg of parts that weigh a gram each),
// and so as many more as it takes to tell it.
#pragma once

#include <string>
#include <vector>

#include "search/evaluate/objectives.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

// At least as many as are asked for.
int shown_decimals(Objective objective, double value, int at_least);
// Returns the decimals of the objective for this value.
int shown_decimals(Objective objective, double value);
// Returns the decimals of a column: as many as any of its cells takes.
int shown_decimals(Objective objective, const std::vector<ListedDesign>& designs);

// Counts without decimals, others with three: of a cost as many more as tell it.
std::string objective_text(Objective objective, double value);

// "-" if it is none.
std::string shown_value(Objective objective, double value);

}  // namespace reeve::reports
