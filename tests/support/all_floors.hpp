// Tests and benchmarks look at every floor: in them, `reeve` has all names (numerics/floors.hpp).
// Included in each of their sources by the compiler (-include).
#pragma once

#include "numerics/floors.hpp"

namespace reeve {

using namespace numerics;
using namespace core;
using namespace causes;
using namespace search;
using namespace catalog;
using namespace diagnosis;
using namespace studies;
using namespace reports;
using namespace pages;
using namespace cli;

}  // namespace reeve
