// Whether what a sensor reads falls while the load grows: what tells a sensor that is the other way
// round, of readings and of samples alike.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::readings {

class SignCount {
 public:
  void add(double tension_N) {
    ++given_;
    below_ += tension_N < 0 ? 1 : 0;
  }
  // Four of five, and enough to tell.
  bool nearly_all_below() const {
    return given_ >= 5 && static_cast<double>(below_) >= 0.8 * static_cast<double>(given_);
  }

 private:
  std::size_t given_ = 0;
  std::size_t below_ = 0;
};

// Of rows alike but for the load, about their own means: what arrives of a load depends on all
// else.
struct LoadedRows {
  double rows = 0;
  double mean_load = 0, mean_reading = 0;
  double square_load = 0, square_reading = 0;
  double product = 0;

  void add(double load, double reading) {
    ++rows;
    const double load_off = load - mean_load;
    const double reading_off = reading - mean_reading;
    mean_load += load_off / rows;
    mean_reading += reading_off / rows;
    square_load += load_off * (load - mean_load);
    square_reading += reading_off * (reading - mean_reading);
    product += load_off * (reading - mean_reading);
  }
};

// By the mean correlation over the groups, of which each has a size of its own; of two rows it
// would be ±1. Noise and friction leave far more than -0.5 of it, a drifting zero far less.
inline bool falls_with_load(const std::vector<LoadedRows>& groups) {
  double sum = 0;
  double weights = 0;
  for (const LoadedRows& alike : groups) {
    const double scale = std::sqrt(alike.square_load * alike.square_reading);
    if (alike.rows < 3 || !(scale > 0)) continue;
    sum += (alike.rows - 1) * alike.product / scale;
    weights += alike.rows - 1;
  }
  return weights > 0 && sum / weights < -0.5;
}

}  // namespace reeve::readings
