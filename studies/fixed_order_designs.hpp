// The designs of one tendon that passes fingers 1, 2, …, n in this order: joins T or P between
// them, and the outer strands closed in one of four ways: both on the motor, one on the motor and
// one fixed (the motor at finger 1), both fixed, or both round one movable pulley.
#pragma once

#include <vector>

#include "core/routing.hpp"

namespace reeve::studies {

inline constexpr int closings_in_fixed_order = 4;

// All that a motor pulls, each once.
std::vector<Routing> fixed_order_designs(int fingers);

}  // namespace reeve::studies
