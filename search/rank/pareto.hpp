// Dominance and fronts over plain numbers.
//
// A design is a row of goodness values, one for each chosen objective, larger is better. A row
// dominates another if it is nowhere worse and somewhere better; front 1 are the rows that none
// dominates, front k + 1 those that only rows of fronts 1 … k do (N. Srinivas, K. Deb, 1994). Equal
// rows do not dominate each other.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "search/evaluate/objectives.hpp"

namespace reeve::search {

// Never on the heap: there are few objectives.
using Goodness = Eigen::Array<double, Eigen::Dynamic, 1, 0, objective_count, 1>;
// Column by column, so that one row is compared with many at a time.
using GoodnessMatrix = Eigen::ArrayXXd;

Goodness goodness(const ObjectiveValues& values, const std::vector<Objective>& objectives);

// Returns the second of at most two values; 0 if there is one.
double second_value(const Goodness& goodness);

bool dominates(const Goodness& a, const Goodness& b);

// Counts the first `rows` rows that dominate `candidate`; stops at `enough`.
Eigen::Index count_dominators(const GoodnessMatrix& matrix, Eigen::Index rows,
                              const Goodness& candidate, Eigen::Index enough);

// The front of each row, from 1.
std::vector<int> fronts(const GoodnessMatrix& matrix);

}  // namespace reeve::search
