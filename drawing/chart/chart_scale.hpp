// From a quantity to pixels and back.
//
// p(v) = from + (f(v) − f(low)) / (f(high) − f(low)) · (to − from), where f(v) = v, or with
// c = linear_to > 0 f(v) = sign(v) ln(1 + |v| / c): linear where |v| ≪ c, logarithmic where |v| ≫
// c, so that 0 and both signs have a place (Webber, "A bi-symmetric log transformation for
// wide-range data", Meas. Sci. Technol. 24, 2013).
#pragma once

#include <limits>

#include "numerics/floors.hpp"

namespace reeve::drawing::chart {

struct Scale {
  double low = 0;  // of the quantity; less than `high`
  double high = 1;
  double from = 0;  // pixels: where `low` lies
  double to = 1;
  double linear_to = 0;
};

double place(const Scale& scale, double value);
double value(const Scale& scale, double place);

// Numbers that an axis can hold: finite, and no further from 0 than 1e100.
bool can_be_drawn(double value);

// From the least to the greatest of some numbers; empty at first.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool empty() const { return low > high; }
  // Leaves out what cannot be drawn.
  void add(double value);
  void add(const Extent& other);
};

}  // namespace reeve::drawing::chart
