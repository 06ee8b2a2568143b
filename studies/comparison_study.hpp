// Measured tensions beside those of the model, by the routings' names.
#pragma once

#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "core/hardware.hpp"
#include "diagnosis/comparison.hpp"
#include "diagnosis/data/measured_data.hpp"

namespace reeve {

struct CompareReport {
  MeasuredData data;
  std::vector<std::string> names;  // of data.routings; "" where there is none
  Hardware hardware;
  Comparison comparison;
};

// Throws InputError if there is nothing to compare.
CompareReport comparison_study(MeasuredData data, const Hardware& hardware,
                               const Catalogue& catalogue);

}  // namespace reeve
