// Tests and benchmarks look at every floor: in them, `reeve` has all names (numerics/floors.hpp).
// Included in each of their sources by the compiler (-include).
#pragma once

#include "numerics/floors.hpp"

namespace reeve {

using namespace cli;

}  // namespace reeve
