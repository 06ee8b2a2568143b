// On which side of the model readings are that are far from it.
//
// Noise chooses none, whatever the load. So of rows with such readings, of which each counts once,
// half are on either side (the sign test), and those of greater loads are on no other side than
// those of lesser ones (the rank sum of H. B. Mann and D. R. Whitney, Ann. Math. Stat. 18, 1947,
// as normal as it is for many). A zero that has moved reads more throughout; a sensor that sticks,
// more of small loads and less of great ones.
#pragma once

#include <vector>

#include "diagnosis/verdict/far_cells.hpp"

namespace reeve::diagnosis {

struct FarSides {
  std::size_t above = 0;  // cells
  std::size_t below = 0;
  double p_value = 1;  // of the rarer of both, which are looked at
};

// All of them far, in the order of their readings.
FarSides far_sides(const std::vector<JudgedCell>& far);

}  // namespace reeve::diagnosis
