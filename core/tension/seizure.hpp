// A contact that does not slide whatever pulls on it: a tube pinched by its clamp.
//
// The tendon ends there on both sides, so that one tendon becomes two (a loop becomes open) and
// either side may carry any tension. A finger whose tip is seized has its two strands on two
// tendons; split_kinematics.hpp says how it closes then.
#pragma once

#include <cstddef>
#include <vector>

#include "core/network.hpp"
#include "core/tension/tension.hpp"

namespace reeve::core {

// Segments and contacts are those of the original network in another order. A seized contact stays
// in the array of contacts and belongs to no tendon.
struct SeizedNetwork {
  Network network;
  std::vector<std::size_t> segment_from;  // the original index of each segment
  std::vector<std::size_t> contact_from;
};

SeizedNetwork seize(const Network& network, const std::vector<std::size_t>& contacts);

// The state of a seized network in the order of the original one.
TensionState restored(const SeizedNetwork& seized, const TensionState& state);

}  // namespace reeve::core
