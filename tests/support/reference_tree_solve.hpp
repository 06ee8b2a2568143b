// The reference model for words with blocks. For tendons that no block joins it gives what the
// solver of single tendons gives, by another way.
#pragma once

#include <set>
#include <vector>

#include "tests/support/reference_model.hpp"
#include "tests/support/reference_walk.hpp"

namespace reeve::testing::reference {

ReferenceResult solve_trees(const std::vector<Tendon>& tendons, const std::set<int>& held,
                            ReferenceDirection direction, const ReferenceHardware& hardware);

}  // namespace reeve::testing::reference
