// What every schematic must keep: each segment once and from contact to contact, nothing over
// anything else.
#pragma once

#include "core/grasp.hpp"
#include "core/routing.hpp"

namespace reeve::testing {

// Fails the running test for everything that lies over something else in the drawing.
void expect_sound(const Routing& routing, Grasp held);

}  // namespace reeve::testing
