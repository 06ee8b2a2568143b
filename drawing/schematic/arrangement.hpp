// The order in which the fittings of a drawing stand from left to right: fingers by number, the
// others so that lines cross each other seldom and are short.
#pragma once

#include "drawing/schematic/columns.hpp"

namespace reeve::drawing {

struct Arrangement {
  Lanes lanes;
  FloatingHeights heights;
  Columns columns;
};

// Mirrors fittings where that helps.
Arrangement arrange(const Network& network, double palm, Fittings& all);

}  // namespace reeve::drawing
