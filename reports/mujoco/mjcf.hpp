// A routing as a model of MuJoCo (MJCF): a planar hand without friction.
//
//   finger      a chain of hinges with the ranges, springs and arms of the hardware, and a
//               *runner*, a slider on which its strands hang: equality constraints hold the
//               runner's travel to Σ r_j q_j, the tendon that joints with constant arms r_j give
//               up. Without joints the runner alone, on a spring.
//   carriage    a slider that the actuator `motor` pulls
//   end         at a motor, on a spool of its own or behind a spring in series: a slider that moves
//               at the spool's ratio, or that the spring joins to the spool
//   block       a slider; a bar's arms are two more, held to its pivot's travel by
//               z = (l u + r v)/(l + r), so that their tensions stand in the ratio l : r
//   tendon      a spatial tendon over sites for each rope (rope_plan.hpp), its length held by an
//               equality constraint
//
// At rest the tensions are those of the tension model with all friction exponents 0, as long as no
// tendon would have to push. MuJoCo's tendons cannot carry friction at contacts: the exponents are
// in the file as data that nothing acts on, and its first lines say so. Several trees of tendons
// share the motor's pull as the springs of their fingers ask, not by equal take-up. Masses and
// damping only bring the rig to rest.
#pragma once

#include <string>

#include "core/hardware.hpp"
#include "core/routing.hpp"

namespace reeve::reports {

// Origin of the model, for the file's first lines; "" is left out.
struct MjcfOrigin {
  std::string name;      // the routing's, in the catalogue
  std::string hardware;  // source of the hardware: a file, the catalogue, the defaults
};

// Throws InputError of hardware that does not fit, OutOfRange where blocks are free to move against
// each other.
std::string mjcf(const Routing& routing, const Hardware& hardware, const MjcfOrigin& origin = {});

}  // namespace reeve::reports
