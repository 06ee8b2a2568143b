// Tests if the readings of a row scatter together, as they do if the recorded motor tension is
// wrong.
//
// With s = dm/dT_M T_M / sd of a row's readings, e their residuals, a motor tension that is off by
// a share of standard deviation τ from row to row leaves
//
//   z = s·e / |s|,   z ~ N(0, 1 + τ² |s|²)
//
// and τ is found by maximum likelihood over the rows that have two readings or more: of one, noise
// could say the same. Rows whose motor tension is told to scatter already have no part in it.
#pragma once

#include <optional>

#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

struct RowScatter {
  double relative = 0;             // τ
  double log_likelihood_gain = 0;  // over τ = 0
};

// Nothing where chance would do as much in one of a thousand sets of data without it.
std::optional<RowScatter> row_scatter(const Problem& problem, const Forecast& at);

}  // namespace reeve::diagnosis
