// Values in the middle or above most, which a few wild ones do not move.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::diagnosis {

// The mean of the two in the middle of an even number; 0 of none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

// Of as many values as a quarter of them are above; 0 of none.
inline double upper_quartile(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 3 / 4);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace reeve::diagnosis
