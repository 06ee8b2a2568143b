// A list of designs as columns for a data frame: those of designs.csv, in its order.
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "studies/listed_design.hpp"

namespace reeve::python {

pybind11::dict design_columns(const std::vector<studies::ListedDesign>& designs);

// Returns the units of the objectives, by column.
pybind11::dict objective_units();

}  // namespace reeve::python
