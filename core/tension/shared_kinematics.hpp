// Computes the closing of fingers that several trees of tendons share: second flexors, extensors.
//
// An extensor gives up −dl. Each tree that some carriage pulls closes (opens) its fingers by one
// common amount Λ_t >= 0, as tree_kinematics.hpp does for a tree alone, and a finger closes by the
// sum over its trees. No tree has more length left than its strands take up:
//
//   Σ_{strands of t} ± dl_f >= motor sides of t,   equal where Λ_t > 0
//
// A tree is slack if the others make it give up more. Trees that no carriage pulls follow without
// tension. If they let out too little, or trees ask one finger for two closings, the grasp jams.
//
// Solved tree by tree until nothing changes (Gauss-Seidel, of a complementarity problem); if steps
// do not get smaller, trees pull against each other.
#pragma once

#include "core/tension/split_kinematics.hpp"

namespace reeve::core {

SplitClosing shared_closing(const Network& network, const Mechanics& mechanics, Grasp grasp);

}  // namespace reeve::core
