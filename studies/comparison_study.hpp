// Measured tensions beside those of the model, by the routings' names.
#pragma once

#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "causes/model.hpp"
#include "diagnosis/comparison.hpp"
#include "readings/measured_data.hpp"

namespace reeve::studies {

struct CompareReport {
  MeasuredData data;
  std::vector<std::string> names;  // names of data.routings; "" if a routing has none
  Model model;
  Comparison comparison;
};

// Throws InputError if there is nothing to compare, OutOfRange where the model has no tensions.
CompareReport comparison_study(MeasuredData data, const Model& model, const Catalogue& catalogue);

}  // namespace reeve::studies
