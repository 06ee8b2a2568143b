// How many digits numbers need so that those that differ are seen to differ, and values of
// objectives as text: with the decimals of the objective. A cost has the unit of somebody's prices,
// of which two decimals may tell nothing (kg of parts that weigh a gram each), and so as many more
// as it takes to tell it.
#pragma once

#include <string>
#include <vector>

#include "search/evaluate/objectives.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

// Significant digits, at least so many and at most 12, at which no two of the values that differ
// read the same.
int telling_digits(std::vector<double> values, int at_least = 4);

// Decimals, at least so many and at most 9, at which what spans so much takes as many steps.
int telling_decimals(double span, std::size_t steps, int at_least);

// Decimals, at least so many and at most 10, at which a value has three significant digits, less
// the zeros that these end with: 2 of 17.05 and of 0.3, 4 of 0.0021, if at least 2.
int significant_decimals(double value, int at_least);

// Rounded to four significant digits or to the unit, whichever is finer, never to the other side:
// up or down.
enum class Rounding { up, down };
std::string rounded_text(double value, Rounding way);

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
